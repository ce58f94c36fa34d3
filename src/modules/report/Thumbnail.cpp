#include "report/Thumbnail.hpp"

#include "io/GreyImage.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <openssl/evp.h>

namespace naocal {

namespace {

std::string base64(std::string_view bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0'); // OpenSSL ends it with a zero
  EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), reinterpret_cast<const unsigned char*>(bytes.data()),
                  static_cast<int>(bytes.size()));
  text.pop_back();
  return text;
}

} // namespace

std::optional<std::string> thumbnail(const std::filesystem::path& file) {
  constexpr int widest = 640; // [px]
  try {
    GreyPicture picture = readPicture(file);
    cv::Mat grey{picture.height, picture.width, CV_8UC1, picture.pixels.data()};
    if (grey.cols > widest) {
      const double scale = static_cast<double>(widest) / grey.cols;
      cv::resize(grey, grey, {widest, std::max(1, cvRound(scale * grey.rows))}, 0, 0, cv::INTER_AREA);
    }
    return "data:image/jpeg;base64," + base64(jpeg({grey.data, grey.total()}, grey.cols, grey.rows, 70));
  } catch (const InputError&) { // lost or broken: the report does without
    return std::nullopt;
  }
}

} // namespace naocal
