#include "synthetic/RenderingSensor.hpp"

#include "io/GreyImage.hpp"

#include <algorithm>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace naocal {

std::vector<float> blotches(int width, int height, std::mt19937_64& random) {
  const cv::Size size{width, height};
  std::normal_distribution<float> normal;
  cv::Mat1f sum(size, 0.f);
  for (const int pixels : {160, 40, 10}) {
    cv::Mat1f coarse(size.height / pixels + 2, size.width / pixels + 2);
    std::generate(coarse.begin(), coarse.end(), [&] { return normal(random); });
    cv::Mat1f fine;
    cv::resize(coarse, fine, size, 0, 0, cv::INTER_CUBIC);
    sum += fine;
  }
  sum /= std::sqrt(3.f);
  return {sum.begin(), sum.end()};
}

GreyPicture developed(std::vector<float> light, int width, int height, const Appearance& appearance,
                      std::mt19937_64& random) {
  cv::Mat1f image(height, width, light.data());
  image = image * float(appearance.white - appearance.black) + float(appearance.black);
  if (appearance.vignetting > 0) {
    const float centreX = float(width - 1) / 2, centreY = float(height - 1) / 2;
    const float cornerSquared = centreX * centreX + centreY * centreY;
    image.forEach([&](float& grey, const int* at) {
      const float x = float(at[1]) - centreX, y = float(at[0]) - centreY;
      grey *= 1 - float(appearance.vignetting) * (x * x + y * y) / cornerSquared;
    });
  }
  if (appearance.blur > 0) {
    cv::GaussianBlur(image, image, {}, appearance.blur);
  }
  if (appearance.noise > 0) {
    boost::random::normal_distribution<float> noise{0, float(appearance.noise)}; // half the time of the standard's
    std::for_each(image.begin(), image.end(), [&](float& grey) { grey += noise(random); });
  }
  cv::Mat1b grey;
  image.convertTo(grey, CV_8U);
  if (appearance.jpegQuality) {
    return decodedPicture(jpeg({grey.data, grey.total()}, width, height, *appearance.jpegQuality), "a picture");
  }
  return {grey.cols, grey.rows, {grey.begin(), grey.end()}};
}

} // namespace naocal
