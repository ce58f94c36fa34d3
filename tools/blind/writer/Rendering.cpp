#include "writer/Rendering.hpp"

#include "world/Pictures.hpp"
#include "writer/SetFile.hpp"

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <memory>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>
#include <png.h>
#include <stdexcept>

namespace blind {

namespace {

constexpr int finer = 3;                                 // supersampling: canvas pixels per image pixel and side
constexpr int printed = 64;                              // pixels of the printed sheet per square
constexpr double paper = 0.25;                           // margin round the squares [squares]
constexpr double floorGrey = 105, ink = 40, white = 190; // grey levels

/// The printed sheet with its margin: black at the top left, markers on white in reading order.
cv::Mat printedSheet(int firstMarker) {
  const int margin = static_cast<int>(paper * printed);
  cv::Mat sheet(Sheet::squaresY * printed + 2 * margin, Sheet::squaresX * printed + 2 * margin, CV_8U,
                cv::Scalar{white});
  const cv::Ptr<cv::aruco::Dictionary> dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_100);
  const int size = static_cast<int>(printed * Sheet::marker / Sheet::square), border = (printed - size) / 2;
  int marker = firstMarker;
  for (int row = 0; row < Sheet::squaresY; ++row) {
    for (int column = 0; column < Sheet::squaresX; ++column) {
      const cv::Rect square{margin + column * printed, margin + row * printed, printed, printed};
      if ((row + column) % 2 == 0) {
        sheet(square).setTo(ink);
      } else {
        cv::Mat bits;
        dictionary->drawMarker(marker++, size, bits, 1);
        bits.convertTo(sheet(cv::Rect{square.x + border, square.y + border, size, size}), CV_8U, (white - ink) / 255,
                       ink);
      }
    }
  }
  return sheet;
}

/// Lines between cells, in squares: edges of the sheet and of the squares.
std::vector<double> cellLines(int squares) {
  std::vector<double> lines{-paper};
  for (int i = 0; i <= squares; ++i) {
    lines.push_back(i);
  }
  lines.push_back(squares + paper);
  return lines;
}

/// Image position on the canvas; pixel (0, 0) is a pixel centre in both.
cv::Point2f onCanvas(const Eigen::Vector2d& seen) {
  return {static_cast<float>(finer * (seen.x() + 0.5) - 0.5), static_cast<float>(finer * (seen.y() + 0.5) - 0.5)};
}

/// Sheet position (in squares) in the printed image.
cv::Point2f onPrint(double right, double down) {
  return {static_cast<float>((right + paper) * printed - 0.5), static_cast<float>((down + paper) * printed - 0.5)};
}

/// Supersampled image, and the area painted so far.
struct Canvas {
  cv::Mat grey = cv::Mat(finer * LensDistortion::height, finer* LensDistortion::width, CV_8U);
  cv::Rect painted;

  void clear() {
    grey.setTo(floorGrey);
    painted = {};
  }
};

void paintCell(const cv::Mat& sheet, const std::array<cv::Point2f, 4>& from, const std::array<cv::Point2f, 4>& to,
               Canvas& canvas) {
  const std::vector<cv::Point2f> outline(to.begin(), to.end());
  const cv::Rect room = cv::boundingRect(outline) & cv::Rect{{}, canvas.grey.size()};
  if (room.empty() || cv::contourArea(outline) < 1) {
    return;
  }
  std::array<cv::Point2f, 4> inRoom = to;
  std::vector<cv::Point> polygon;
  constexpr int fraction = 4; // fractional bits
  for (cv::Point2f& point : inRoom) {
    point -= cv::Point2f{static_cast<float>(room.x), static_cast<float>(room.y)};
    polygon.emplace_back(cvRound(point.x * (1 << fraction)), cvRound(point.y * (1 << fraction)));
  }
  cv::Mat warped, mask = cv::Mat::zeros(room.size(), CV_8U);
  cv::warpPerspective(sheet, warped, cv::getPerspectiveTransform(from.data(), inRoom.data()), room.size(),
                      cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  cv::fillConvexPoly(mask, polygon, 255, cv::LINE_8, fraction);
  warped.copyTo(canvas.grey(room), mask);
  canvas.painted |= room;
}

void paintBoard(const TruePictures& pictures, const BoardSight& sight, const cv::Mat& sheet, Canvas& canvas) {
  const std::vector<double> columns = cellLines(Sheet::squaresX), rows = cellLines(Sheet::squaresY);
  std::vector<Eigen::Vector2d> grid;
  for (const double down : rows) {
    for (const double right : columns) {
      grid.emplace_back(right, down);
    }
  }
  const std::vector<Eigen::Vector2d> seen = pictures.points(sight, grid);
  for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
    for (std::size_t column = 0; column + 1 < columns.size(); ++column) {
      const std::size_t at = row * columns.size() + column, below = at + columns.size();
      const std::array<std::size_t, 4> corners{at, at + 1, below + 1, below};
      std::array<cv::Point2f, 4> from, to;
      bool inFront = true;
      for (std::size_t i = 0; i < 4; ++i) {
        from[i] = onPrint(grid[corners[i]].x(), grid[corners[i]].y());
        to[i] = onCanvas(seen[corners[i]]);
        inFront = inFront && seen[corners[i]].cwiseAbs().maxCoeff() < 4 * LensDistortion::width; // false for NaN
      }
      if (inFront) {
        paintCell(sheet, from, to, canvas);
      }
    }
  }
}

cv::Mat developed(const Canvas& canvas, RandomStream& chance) {
  constexpr double blur = 0.7, noise = 3; // [px], [grey levels]
  cv::Mat picture(LensDistortion::height, LensDistortion::width, CV_8U, cv::Scalar{floorGrey}),
      grain(picture.size(), CV_16S);
  const cv::Rect all{{}, picture.size()};
  const int reach = 4; // of the blur [px]
  const cv::Point first = canvas.painted.tl() / finer - cv::Point{reach, reach},
                  last = canvas.painted.br() / finer + cv::Point{reach + 1, reach + 1};
  if (const cv::Rect seen = cv::Rect{first, last} & all; !canvas.painted.empty()) {
    const cv::Rect fine{seen.tl() * finer, seen.br() * finer};
    cv::Mat blurred;
    cv::GaussianBlur(canvas.grey(fine), blurred, {}, blur * finer);
    cv::resize(blurred, picture(seen), seen.size(), 0, 0, cv::INTER_AREA);
  }
  cv::RNG{chance.next()}.fill(grain, cv::RNG::NORMAL, 0, noise);
  cv::add(picture, grain, picture, cv::noArray(), CV_8U);
  return picture;
}

void writePng(const cv::Mat& picture, const std::string& file) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream{std::fopen(file.c_str(), "wb"), std::fclose};
  png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(writer);
  if (!stream || setjmp(png_jmpbuf(writer)) != 0) { // libpng jumps here on failure
    throw std::runtime_error{file + ": cannot be written"};
  }
  png_init_io(writer, stream.get());
  png_set_IHDR(writer, info, static_cast<png_uint_32>(picture.cols), static_cast<png_uint_32>(picture.rows), 8,
               PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_filter(writer, 0, PNG_FILTER_NONE);
  png_set_compression_level(writer, 0); // uncompressed: read once, then deleted
  png_write_info(writer, info);
  for (int row = 0; row < picture.rows; ++row) {
    png_write_row(writer, picture.ptr(row));
  }
  png_write_end(writer, info);
  png_destroy_write_struct(&writer, &info);
}

} // namespace

void renderSession(const Robot& robot, const Session& session, RandomStream& chance,
                   const std::filesystem::path& folder) {
  cv::setNumThreads(1); // several sets are written in parallel
  std::filesystem::create_directories(folder / "images");
  const TruePictures pictures{robot, session};
  std::vector<cv::Mat> sheets;
  for (std::size_t board = 0; board < session.boards.size(); ++board) {
    sheets.push_back(printedSheet(static_cast<int>(board) * (Sheet::squaresX * Sheet::squaresY / 2)));
  }
  Canvas canvas;
  for (int reading = 0; reading < static_cast<int>(session.readings.size()); ++reading) {
    for (int camera = 0; camera < 2; ++camera) {
      canvas.clear();
      for (int board = 0; board < static_cast<int>(sheets.size()); ++board) {
        paintBoard(pictures, {reading, camera, board, {}, 0}, sheets[board], canvas);
      }
      const std::string file = (folder / imageName(reading, camera)).string();
      writePng(developed(canvas, chance), file);
    }
  }
}

} // namespace blind
