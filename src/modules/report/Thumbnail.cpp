#include "report/Thumbnail.hpp"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <openssl/evp.h>
#include <vector>

namespace naocal {

namespace {

std::string base64(const std::vector<unsigned char>& bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0'); // OpenSSL ends it with a zero
  EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), bytes.data(), static_cast<int>(bytes.size()));
  text.pop_back();
  return text;
}

} // namespace

std::optional<std::string> thumbnail(const std::filesystem::path& file) {
  constexpr int widest = 640; // [px]
  try {
    cv::Mat picture = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
    if (picture.empty()) {
      return std::nullopt;
    }
    if (picture.cols > widest) {
      const double scale = static_cast<double>(widest) / picture.cols;
      cv::resize(picture, picture, {widest, std::max(1, cvRound(scale * picture.rows))}, 0, 0, cv::INTER_AREA);
    }
    std::vector<unsigned char> jpeg;
    cv::imencode(".jpg", picture, jpeg, {cv::IMWRITE_JPEG_QUALITY, 70});
    return "data:image/jpeg;base64," + base64(jpeg);
  } catch (const cv::Exception&) { // broken files; OpenCV has no other way to say so
    return std::nullopt;
  }
}

} // namespace naocal
