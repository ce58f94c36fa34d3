#include "io/GreyImage.hpp"

#include "../TemporaryFolder.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

using namespace naocal;

namespace {

/// A gradient with a disc: not constant, all rows different.
GreyPicture drawing(int width, int height) {
  GreyPicture picture{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool disc = std::hypot(x - width / 2., y - height / 2.) < width / 4.;
      picture.pixels.push_back(static_cast<std::uint8_t>(disc ? 200 - y : 2 * x + y));
    }
  }
  return picture;
}

cv::Mat image(const GreyPicture& picture) {
  return cv::Mat{picture.height, picture.width, CV_8UC1, const_cast<std::uint8_t*>(picture.pixels.data())}.clone();
}

std::string encoded(const char* ending, const cv::Mat& picture) {
  std::vector<std::uint8_t> bytes;
  REQUIRE(cv::imencode(ending, picture, bytes));
  return {bytes.begin(), bytes.end()};
}

int largestDifference(const GreyPicture& one, const cv::Mat& other) {
  REQUIRE(one.width == other.cols);
  REQUIRE(one.height == other.rows);
  return static_cast<int>(cv::norm(image(one), other, cv::NORM_INF));
}

} // namespace

TEST_CASE("a PNG keeps every grey level, and others read the same in it") {
  // Compares writing with OpenCV's reader and reading with OpenCV's writer, including odd sizes.
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {64, 48}, {101, 33}}) {
    const GreyPicture picture = drawing(width, height);
    const std::string content = encodePng(picture);
    CHECK(decodeImage(content, "it").pixels == picture.pixels);
    const cv::Mat bytes(1, static_cast<int>(content.size()), CV_8U, const_cast<char*>(content.data()));
    CHECK(largestDifference(picture, cv::imdecode(bytes, cv::IMREAD_UNCHANGED)) == 0);
    CHECK(largestDifference(decodeImage(encoded(".png", image(picture)), "it"), image(picture)) == 0);
  }
}

TEST_CASE("colours become their luma, more bits the nearest of eight") {
  // Compares with OpenCV's conversion of the same colours.
  const GreyPicture picture = drawing(40, 30);
  cv::Mat colours, grey, deep;
  cv::applyColorMap(image(picture), colours, cv::COLORMAP_JET);
  cv::cvtColor(colours, grey, cv::COLOR_BGR2GRAY);
  CHECK(largestDifference(decodeImage(encoded(".png", colours), "it"), grey) <= 1);
  CHECK(largestDifference(decodeImage(encoded(".jpg", colours), "it"), grey) < 40); // JPEG subsamples colours
  image(picture).convertTo(deep, CV_16U, 257);
  CHECK(largestDifference(decodeImage(encoded(".png", deep), "it"), image(picture)) <= 1);
}

TEST_CASE("a JPEG stays near the picture, grey or coloured") {
  // Decodes a grey JPEG with our reader and a coloured one with OpenCV's.
  const GreyPicture picture = drawing(64, 48);
  const std::string grey = encodeJpeg(picture.pixels, 64, 48, 95);
  CHECK(largestDifference(decodeImage(grey, "it"), image(picture)) < 40);
  std::vector<std::uint8_t> red;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    red.insert(red.end(), {200, 30, 10});
  }
  const std::string coloured = encodeJpeg(red, 64, 48, 75);
  const cv::Mat bytes(1, static_cast<int>(coloured.size()), CV_8U, const_cast<char*>(coloured.data()));
  const cv::Scalar mean = cv::mean(cv::imdecode(bytes, cv::IMREAD_COLOR)); // blue, green, red
  CHECK(mean[0] == Approx(10).margin(3));
  CHECK(mean[1] == Approx(30).margin(3));
  CHECK(mean[2] == Approx(200).margin(3));
}

TEST_CASE("what is no whole picture is refused by name") {
  // Proves that truncated files, corrupt data and impossible sizes are refused. Every length is tested.
  const GreyPicture picture = drawing(32, 24);
  const auto refused = [](const std::string& content) {
    CHECK_THROWS_WITH(decodeImage(content, "images/7.png"),
                      Catch::StartsWith("images/7.png: expected a whole picture"));
  };
  const std::string whole = encodePng(picture), photograph = encodeJpeg(picture.pixels, 32, 24, 90);
  for (std::size_t length = 0; length < whole.size() - 12; ++length) { // the last chunk is only an end mark
    refused(whole.substr(0, length));
  }
  for (std::size_t length = 0; length + 2 < photograph.size(); ++length) {
    refused(photograph.substr(0, length));
  }
  refused("GIF89a and more");
  std::string broken = whole;
  broken[broken.size() / 2] ^= 0x55;
  refused(broken);
  std::string huge = whole;
  huge[16] = '\x7f'; // 2 * 10^9 columns
  refused(huge);
}

TEST_CASE("a picture of another size than its camera's is refused by its header") {
  // Proves it for both formats with files whose content is not complete: decoding would refuse them in other words.
  const GreyPicture picture = drawing(64, 48);
  const std::string png = encodePng(picture), jpeg = encodeJpeg(picture.pixels, 64, 48, 90);
  for (const std::string& content : {png, jpeg}) {
    CHECK(imageSize(content, "it") == PictureSize{64, 48});
    CHECK(decodeImage(content, "it", PictureSize{64, 48}).pixels.size() == 64 * 48);
    CHECK_THROWS_WITH(decodeImage(content.substr(0, content.size() / 2), "images/7.png", PictureSize{32, 24}),
                      "images/7.png: the picture has 64 x 48 pixels, but its camera is described with 32 x 24");
  }
  CHECK_THROWS_WITH(imageSize("GIF89a and more", "it"), Catch::Contains("expected a whole picture"));
}

TEST_CASE("a picture has at most 2^26 pixels, by its header") {
  // Proves the boundary with the header of a small JPEG whose size was changed: nothing is decoded.
  const GreyPicture picture = drawing(64, 48);
  const std::string jpeg = encodeJpeg(picture.pixels, 64, 48, 90);
  const std::size_t frame = jpeg.find(std::string("\x00\x30\x00\x40", 4)); // height and width, in the frame's header
  REQUIRE(frame != std::string::npos);
  const auto sized = [&](int width, int height) {
    std::string content = jpeg;
    const int bytes[] = {height >> 8, height & 255, width >> 8, width & 255};
    for (std::size_t i = 0; i < 4; ++i) {
      content[frame + i] = static_cast<char>(bytes[i]);
    }
    return content;
  };
  CHECK(imageSize(sized(8192, 8192), "it") == PictureSize{8192, 8192});
  CHECK_THROWS_WITH(imageSize(sized(8193, 8192), "it"), Catch::Contains("expected a whole picture"));
  CHECK_THROWS_WITH(imageSize(sized(0, 8192), "it"), Catch::Contains("expected a whole picture"));
}

TEST_CASE("a picture is written as its file's name says, or not at all") {
  // Proves both extensions, and the message for any other.
  const TemporaryFolder folder;
  const GreyPicture picture = drawing(32, 24);
  writeImage(picture, folder.path() / "it.png");
  CHECK(readImage(folder.path() / "it.png").pixels == picture.pixels);
  writeImage(picture, folder.path() / "it.jpg");
  CHECK(readFile(folder.path() / "it.jpg").starts_with("\xff\xd8"));
  CHECK_THROWS_WITH(writeImage(picture, folder.path() / "it.gif"), Catch::Contains("found '.gif'"));
  CHECK_THROWS_WITH(readImage(folder.path() / "no.png"), Catch::Contains("there is no such file"));
}
