#include "PdfPicture.hpp"

#include "detect/BoardDetector.hpp"
#include "io/InputError.hpp"
#include "print/BoardSheet.hpp"
#include "simulation/SimulationPlan.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <vector>

using namespace naocal;

namespace {

Board boardOf(const CharucoPattern& pattern) {
  Board board;
  board.id = "A";
  board.pattern = pattern;
  board.points = innerCorners(pattern);
  return board;
}

/// A camera without distortion whose focal length is about the picture's size.
CameraIntrinsics cameraFor(const GreyPicture& picture) {
  return {picture.width,
          picture.height,
          double(picture.width),
          double(picture.width),
          picture.width / 2.0,
          picture.height / 2.0,
          {}};
}

/// Corners of the only board found in a picture, by id [px].
std::map<int, Eigen::Vector2d> findCorners(const GreyPicture& picture, const Board& board) {
  std::map<int, Eigen::Vector2d> corners;
  const Detection detection = detectBoards(picture, {board}, cameraFor(picture));
  for (const BoardCorners& found : detection.boards) {
    for (std::size_t i = 0; i < found.ids.size(); ++i) {
      corners[found.ids[i]] = found.uv[i];
    }
  }
  return corners;
}

/// Sheet positions where grey changes between ink and paper along a row of pixels, interpolated [px].
std::vector<double> edgesAlongRow(const GreyPicture& picture, int row) {
  std::vector<double> edges;
  for (int x = 0; x + 1 < picture.width; ++x) {
    const double here = picture.grey(x, row) - 127.5, next = picture.grey(x + 1, row) - 127.5;
    if (here * next < 0) {
      edges.push_back(x + here / (here - next));
    }
  }
  return edges;
}

std::string message(const auto& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

} // namespace

TEST_CASE("a printed board has true size on every paper, and the project's detector reads it") {
  // Proves: rasterised by another program, all inner corners are found where the true size puts them, to 0.1 mm over
  // the whole sheet, for each paper and for a pattern of the legacy layout. Does not prove anything about printers.
  struct Case {
    const char* paper;
    int columns, rows;
    bool legacy;
    int dotsPerInch;
  };
  for (const Case& each : {Case{"a4", 7, 5, false, 150}, Case{"a3", 5, 3, false, 120}, Case{"a2", 7, 5, false, 100},
                           Case{"a4", 6, 4, true, 150}}) {
    CAPTURE(each.paper, each.columns, each.legacy);
    CharucoPattern pattern;
    pattern.squaresX = each.columns;
    pattern.squaresY = each.rows;
    pattern.legacyPattern = each.legacy;
    pattern.firstMarkerId = 17;
    const Board board = boardOf(fitToPaper(pattern, findPaper(each.paper)));
    PdfDocument pdf{"test", "test"};
    addBoardSheet(pdf, board, findPaper(each.paper));
    const auto picture = drawPage(pdf.finish(), 1, each.dotsPerInch);
    if (!picture) {
      return;
    }
    const double pixelsPerMetre = each.dotsPerInch / 0.0254;
    CHECK(picture->width == Approx(findPaper(each.paper).width / 1000 * pixelsPerMetre).margin(1));
    const auto corners = findCorners(*picture, board);
    REQUIRE(corners.size() == board.points.size());
    const Eigen::Vector2d origin = corners.at(0) / pixelsPerMetre;
    double worst = 0;
    for (const auto& [id, uv] : corners) {
      const Eigen::Vector3d &point = board.points[std::size_t(id)], &first = board.points[0];
      const Eigen::Vector2d expected = origin + Eigen::Vector2d{point.x() - first.x(), first.y() - point.y()};
      worst = std::max(worst, (uv / pixelsPerMetre - expected).norm());
    }
    CHECK(worst < 0.1e-3);
  }
}

TEST_CASE("the default A2 board is the board that planning and simulation assume") {
  // Proves: fitted to A2, the default pattern has the default boards' 80 mm squares and 60 mm markers.
  const Board board = defaultBoards().front();
  const CharucoPattern fitted = fitToPaper(*board.pattern, findPaper("a2"));
  CHECK(fitted.squareLength == Approx(board.pattern->squareLength).epsilon(1e-12));
  CHECK(fitted.markerLength == Approx(board.pattern->markerLength).epsilon(1e-12));
}

TEST_CASE("the squares and the ruler of a sheet are as long as they say") {
  // Proves without the detector: edges between squares in the middle of the first row, and the ruler's centimetre
  // ticks, lie where they should in the rasterised page.
  constexpr int dotsPerInch = 254; // 10 pixels per millimetre
  const Board board = boardOf(CharucoPattern{});
  PdfDocument pdf{"test", "test"};
  addBoardSheet(pdf, board, findPaper("a2"));
  const auto picture = drawPage(pdf.finish(), 1, dotsPerInch);
  if (!picture) {
    return;
  }
  // The pattern is centred: its top left corner lies at (17, 10) mm. 5 mm below the upper edge no marker is crossed.
  const auto edges = edgesAlongRow(*picture, 150);
  for (int column = 0; column <= 7; ++column) {
    const double expected = 10 * (17 + 80.0 * column) - 0.5;
    CAPTURE(column);
    CHECK(
        std::any_of(edges.begin(), edges.end(), [&](double edge) { return std::abs(edge - expected) < 1; })); // 0.1 mm
  }
  // 1.7 mm below the ruler's line only centimetre ticks reach: 21 of them.
  std::vector<double> ticks;
  const auto across = edgesAlongRow(*picture, 10 * (10 + 400) + 8 + 17);
  for (std::size_t i = 0; i + 1 < across.size() && across[i] < 10 * (17 + 202.0); i += 2) {
    if (across[i] > 10 * (17 - 1.0)) {
      ticks.push_back((across[i] + across[i + 1]) / 2);
    }
  }
  REQUIRE(ticks.size() == 21);
  CHECK(ticks.back() - ticks.front() == Approx(2000).margin(1));
}

TEST_CASE("the sheets of a tiled board add up to the board") {
  // Proves: pasted together at their cuts, the rasterised A4 sheets show a board that the detector finds, in true size;
  // and that no cut comes near a corner.
  constexpr int dotsPerInch = 127; // 5 pixels per millimetre
  constexpr double perMillimetre = 5;
  const Board board = boardOf(CharucoPattern{});
  PdfDocument pdf{"test", "test"};
  const std::size_t count = addBoardTiles(pdf, board, findPaper("a4"));
  const std::string bytes = pdf.finish();
  REQUIRE(count == 8);
  // Portrait sheets of 210 mm x 297 mm with 10 mm margins: 4 columns of 1.5, 2, 2 and 1.5 squares, 2 rows.
  const std::vector<double> xs{-11.5, 120, 280, 440, 571.5}, ys{-6, 200, 406};
  GreyPicture whole{int(583 * perMillimetre), int(412 * perMillimetre), {}};
  whole.pixels.assign(std::size_t(whole.width) * std::size_t(whole.height), 255);
  for (std::size_t row = 0; row + 1 < ys.size(); ++row) {
    for (std::size_t column = 0; column + 1 < xs.size(); ++column) {
      const auto sheet = drawPage(bytes, int(row * (xs.size() - 1) + column + 1), dotsPerInch);
      if (!sheet) {
        return;
      }
      REQUIRE(sheet->width < sheet->height);
      for (double y = ys[row]; y < ys[row + 1]; y += 1 / perMillimetre) {
        for (double x = xs[column]; x < xs[column + 1]; x += 1 / perMillimetre) {
          const int fromX = int((10 + x - xs[column]) * perMillimetre + 0.5),
                    fromY = int((10 + y - ys[row]) * perMillimetre + 0.5);
          const auto toX = std::size_t((x + 11.5) * perMillimetre + 0.5),
                     toY = std::size_t((y + 6) * perMillimetre + 0.5);
          if (toX < std::size_t(whole.width) && toY < std::size_t(whole.height)) {
            whole.pixels[toY * std::size_t(whole.width) + toX] = sheet->grey(fromX, fromY);
          }
        }
      }
    }
  }
  const auto corners = findCorners(whole, board);
  REQUIRE(corners.size() == board.points.size());
  const double width = (corners.at(5) - corners.at(0)).norm() / perMillimetre, // 5 squares
      height = (corners.at(18) - corners.at(0)).norm() / perMillimetre;        // 3 squares
  CHECK(width == Approx(400).margin(0.3)); // each cut is rounded to a pixel of 0.2 mm
  CHECK(height == Approx(240).margin(0.3));
}

TEST_CASE("boards that do not fit are refused") {
  // Proves: the refusal names the board, the paper that is needed and a way out.
  PdfDocument pdf{"test", "test"};
  const Board board = boardOf(CharucoPattern{});
  const std::string small = message([&] { addBoardSheet(pdf, board, findPaper("a3")); });
  CHECK(small.find("board A: expected paper of at least 590 mm × 420 mm, found a3") == 0);
  CHECK(small.find("--tile a3") != std::string::npos);
  CharucoPattern huge;
  huge.squareLength = 0.3;
  CHECK(message([&] { addBoardTiles(pdf, boardOf(huge), findPaper("a4")); }).find("expected squares that fit") !=
        std::string::npos);
  CharucoPattern many;
  many.squaresX = many.squaresY = 100;
  CHECK(message([&] { fitToPaper(many, findPaper("a4")); }).find("fewer squares") != std::string::npos);
  CHECK(message([&] { findPaper("letter"); }).find("found letter") != std::string::npos);
}
