#include "print/BoardSheet.hpp"

#include "detect/MarkerDetector.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace naocal {

namespace {

using Eigen::Vector2d;

// Margins around the pattern [mm]: printers leave up to 5 mm of the paper's edge white.
constexpr double sideMargin = 15, topMargin = 10; // at least
constexpr double sideCut = 10.5, topCut = 5;      // where the sheet is cut
constexpr double smallestSquare = 5;
constexpr double tileMargin = 10, tileStrip = 8; // of a sheet: white edge, and what the next sheet is glued onto [mm]
constexpr PageColour grey{0.45, 0.45, 0.45};
constexpr double quarterTurn = std::numbers::pi / 2;

double millimetres(double metres) {
  return 1000 * metres;
}

/// Size of the pattern [mm].
Vector2d patternSize(const CharucoPattern& pattern) {
  return millimetres(pattern.squareLength) * Vector2d{pattern.squaresX, pattern.squaresY};
}

double rulerLength(double room) {
  for (const double length : {200, 150, 100, 50, 20}) {
    if (length <= room) {
      return length;
    }
  }
  return 10;
}

void addMarker(const CharucoPattern& pattern, int marker, const Vector2d& centre, std::vector<PageBox>& black) {
  const Eigen::MatrixXi cells = markerCells(pattern.dictionary, marker);
  const double size = millimetres(pattern.markerLength), cell = size / double(cells.rows());
  for (Eigen::Index row = 0; row < cells.rows(); ++row) {
    for (Eigen::Index first = 0; first < cells.cols(); ++first) {
      Eigen::Index end = first;
      while (end < cells.cols() && cells(row, end) == 0) {
        ++end;
      }
      if (end > first) {
        black.push_back({centre.x() - size / 2 + double(first) * cell, centre.y() - size / 2 + double(row) * cell,
                         double(end - first) * cell, cell});
        first = end;
      }
    }
  }
}

/// The black areas of the pattern, from its top left corner.
std::vector<PageBox> blackBoxes(const CharucoPattern& pattern) {
  const double square = millimetres(pattern.squareLength);
  std::vector<PageBox> black;
  int marker = pattern.firstMarkerId;
  for (int row = 0; row < pattern.squaresY; ++row) {
    for (int column = 0; column < pattern.squaresX; ++column) {
      if (isBlackSquare(pattern, column, row)) {
        black.push_back({column * square, row * square, square, square});
      } else {
        addMarker(pattern, marker++, square * Vector2d{column + 0.5, row + 0.5}, black);
      }
    }
  }
  return black;
}

/// Writes a line, smaller where it would be longer than `room` [mm].
void writeWithin(PdfDocument& pdf, double room, const Vector2d& at, const std::string& text, TextStyle style) {
  style.size *= std::min(1.0, room / pdf.textWidth(text, style.size, style.bold));
  pdf.write(at, text, style);
}

/// Draws a ruler from `zero` along `direction`, with ticks every millimetre towards `outwards`, and centimetres.
void drawRuler(PdfDocument& pdf, const Vector2d& zero, const Vector2d& direction, const Vector2d& outwards,
               double length) {
  constexpr double fine = 0.1, numberSize = 2.2;
  pdf.drawLine(zero, zero + length * direction, fine);
  for (int i = 0; i <= std::lround(length); ++i) {
    const Vector2d foot = zero + i * direction;
    const double tick = i % 10 == 0 ? 1.9 : i % 5 == 0 ? 1.4 : 0.9;
    pdf.drawLine(foot, foot + tick * outwards, i % 10 == 0 ? 2 * fine : fine);
    if (i % 10 == 0) {
      const bool isUpright = direction.x() == 0;
      const Vector2d at = isUpright ? Vector2d(foot + 2.2 * outwards + Vector2d{0, 0.36 * numberSize})
                                    : Vector2d(foot + (2.2 + 0.72 * numberSize) * outwards);
      pdf.write(at, std::to_string(i / 10),
                {.size = numberSize, .align = isUpright ? TextAlign::right : TextAlign::centre});
    }
  }
}

void drawRulers(PdfDocument& pdf, const CharucoPattern& pattern) {
  constexpr double gap = 0.8;
  const Vector2d size = patternSize(pattern);
  const PrintedRulers rulers = printedRulers(pattern);
  const double alongRows = millimetres(rulers.alongRows), alongColumns = millimetres(rulers.alongColumns);
  drawRuler(pdf, {0, size.y() + gap}, Vector2d::UnitX(), Vector2d::UnitY(), alongRows);
  drawRuler(pdf, {-gap, size.y()}, -Vector2d::UnitY(), -Vector2d::UnitX(), alongColumns);
  if (const double room = size.x() - alongRows - 5; room > 20) {
    writeWithin(pdf, room, {alongRows + 5, size.y() + 3.8},
                fmt::format("This ruler should be {:g} mm long, the one at the left {:g} mm.", alongRows, alongColumns),
                {.size = 2.6, .colour = grey});
  }
}

/// Writes instructions beside the pattern's right edge, to be read from the right.
void writeInstructions(PdfDocument& pdf, const Board& board) {
  const Vector2d size = patternSize(*board.pattern);
  const PrintedRulers rulers = printedRulers(*board.pattern);
  const std::array<std::string, 3> lines{
      fmt::format(
          "1  Print at 100 %, not \"fit to page\", on matt paper.   2  Measure both rulers with a steel rule: {:g} mm "
          "along the rows, {:g} mm along the columns.",
          millimetres(rulers.alongRows), millimetres(rulers.alongColumns)),
      fmt::format("3  If they differ, keep the real size [m]:   naocal board --boards boards.json --measured "
                  "{:.4f},{:.4f}   (first along the rows)",
                  0.9975 * rulers.alongRows, 0.9975 * rulers.alongColumns),
      "4  Cut along the corner marks.   5  Glue the sheet flat onto a rigid plate: no bow, no bubbles.   6  Lay it on "
      "the "
      "floor, pattern up."};
  double size3 = 2.7;
  for (const std::string& line : lines) {
    size3 = std::min(size3, 2.7 * size.y() / pdf.textWidth(line, 2.7));
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    pdf.write({size.x() + 8.2 - 3.3 * double(i), 0}, lines[i], {.size = size3, .turn = -quarterTurn});
  }
}

void writeTitle(PdfDocument& pdf, const Board& board) {
  const CharucoPattern& pattern = *board.pattern;
  const double width = patternSize(pattern).x();
  writeWithin(pdf, width - 6, {6, -1.6},
              fmt::format("Board {}     {} × {} squares of {:g} mm     markers of {:g} mm: {}, {} to {}{}     naocal",
                          board.id, pattern.squaresX, pattern.squaresY, millimetres(pattern.squareLength),
                          millimetres(pattern.markerLength), pattern.dictionary, pattern.firstMarkerId,
                          pattern.firstMarkerId + markerCount(pattern) - 1,
                          pattern.legacyPattern ? ", legacy pattern" : ""),
              {.size = 3});
  pdf.fillPolygon({{-0.6, -0.6}, {-3, -1.4}, {-1.4, -3}}, {}); // points at the corner that placements refer to
  writeWithin(pdf, 7.5, {-5.6, 10.5}, board.id, {.size = 10, .align = TextAlign::centre, .bold = true});
}

/// Draws the corners of the rectangle to cut out.
void drawCutMarks(PdfDocument& pdf, const Vector2d& size) {
  constexpr double arm = 4, width = 0.15;
  for (const double x : {-sideCut, size.x() + sideCut}) {
    for (const double y : {-topCut, size.y() + topCut}) {
      pdf.drawLine({x, y}, {x + (x < 0 ? arm : -arm), y}, width);
      pdf.drawLine({x, y}, {x, y + (y < 0 ? arm : -arm)}, width);
    }
  }
}

/// Draws the board with all around it; the origin is the pattern's top left corner.
void drawBoard(PdfDocument& pdf, const Board& board) {
  pdf.fill(blackBoxes(*board.pattern));
  drawRulers(pdf, *board.pattern);
  writeTitle(pdf, board);
  writeInstructions(pdf, board);
  drawCutMarks(pdf, patternSize(*board.pattern));
}

/// Width and height of the paper as it suits a sheet, landscape first; absent if it is too small.
std::optional<Vector2d> orientPaper(const Paper& paper, const Vector2d& sheet) {
  for (const Vector2d& page : {Vector2d{paper.width, paper.height}, Vector2d{paper.height, paper.width}}) {
    if ((sheet.array() <= page.array() + 1e-6).all()) {
      return page;
    }
  }
  return std::nullopt;
}

/// Where a board is cut along one axis, outer edges included, into the fewest parts of at most `most`, about equally
/// long; empty if a square is longer than that. All lengths [mm] from the pattern's edge.
std::vector<double> cutAxis(int squares, double square, double edge, double most) {
  const auto cut = [&](double limit) {
    std::vector<double> cuts{-edge};
    const double end = squares * square + edge;
    while (cuts.back() + limit < end) {
      const double squaresThere = std::floor((cuts.back() + limit) / square - 0.5 + 1e-9);
      const double next = (std::min(squaresThere, squares - 1.0) + 0.5) * square;
      if (squaresThere < 0 || next <= cuts.back()) {
        return std::vector<double>{};
      }
      cuts.push_back(next);
    }
    cuts.push_back(end);
    return cuts;
  };
  std::vector<double> best = cut(most);
  for (double limit = most; !best.empty(); --limit) { // as long as the number of parts stays
    std::vector<double> shorter = cut(limit);
    if (limit <= 0 || shorter.size() != best.size()) {
      break;
    }
    best = std::move(shorter);
  }
  return best;
}

/// The sheets of a tiled board.
struct Tiling {
  Vector2d page;              // width and height of a sheet [mm]
  std::vector<double> xs, ys; // cuts, from the pattern's top left corner [mm]
  std::size_t count() const { return xs.empty() || ys.empty() ? 0 : (xs.size() - 1) * (ys.size() - 1); }
};

Tiling tile(const CharucoPattern& pattern, const Vector2d& page) {
  const Vector2d most = page - Vector2d::Constant(2 * tileMargin + tileStrip);
  const double square = millimetres(pattern.squareLength);
  return {page, cutAxis(pattern.squaresX, square, sideCut + 1, most.x()),
          cutAxis(pattern.squaresY, square, topCut + 1, most.y())};
}

/// Adds one sheet of a tiled board.
void addTile(PdfDocument& pdf, const Board& board, const Tiling& tiling, std::size_t column, std::size_t row) {
  const std::size_t columns = tiling.xs.size() - 1, rows = tiling.ys.size() - 1;
  const bool isLastColumn = column + 1 == columns, isLastRow = row + 1 == rows;
  const Vector2d from{tiling.xs[column], tiling.ys[row]}, to{tiling.xs[column + 1], tiling.ys[row + 1]};
  const Vector2d cell = to - from, start = Vector2d::Constant(tileMargin);
  pdf.addPage(tiling.page.x(), tiling.page.y());
  pdf.setOrigin(start - from);
  pdf.beginClip(
      {from.x(), from.y(), cell.x() + (isLastColumn ? 0 : tileStrip), cell.y() + (isLastRow ? 0 : tileStrip)});
  drawBoard(pdf, board);
  pdf.endClip();
  pdf.setOrigin(start);
  constexpr double near = 1, far = 4.5, width = 0.15;
  for (const double x : {0.0, cell.x()}) {
    const double below = cell.y() + (isLastRow ? 0 : tileStrip);
    if (x > 0 ? !isLastColumn : column > 0) {
      pdf.drawLine({x, -far}, {x, -near}, width);
      pdf.drawLine({x, below + near}, {x, below + far}, width);
    }
  }
  for (const double y : {0.0, cell.y()}) {
    const double beside = cell.x() + (isLastColumn ? 0 : tileStrip);
    if (y > 0 ? !isLastRow : row > 0) {
      pdf.drawLine({-far, y}, {-near, y}, width);
      pdf.drawLine({beside + near, y}, {beside + far, y}, width);
    }
  }
  writeWithin(
      pdf, cell.x() - 6, {3, -1.8},
      fmt::format("Board {}: sheet {} of {}, column {} of {}, row {} of {}.  Cut the left and upper edges at the "
                  "ticks; glue them over the {:g} mm strips of the sheets at the left and above.",
                  board.id, row * columns + column + 1, rows * columns, column + 1, columns, row + 1, rows, tileStrip),
      {.size = 2.6, .colour = grey});
}

void requirePrintable(const Board& board) {
  if (millimetres(board.pattern->squareLength) < smallestSquare) {
    throw InputError{fmt::format("board {}: expected squares of at least {:g} mm to print, found {:g} mm", board.id,
                                 smallestSquare, millimetres(board.pattern->squareLength))};
  }
}

} // namespace

PrintedRulers printedRulers(const CharucoPattern& pattern) {
  constexpr double letter = 25; // the board's id is written beside the first row [mm]
  const Vector2d size = patternSize(pattern);
  return {rulerLength(size.x()) / 1000, rulerLength(size.y() - letter) / 1000};
}

CharucoPattern fitToPaper(CharucoPattern pattern, const Paper& paper) {
  double square = 0;
  for (const auto& [width, height] : {std::pair{paper.width, paper.height}, std::pair{paper.height, paper.width}}) {
    square = std::max(square, std::floor(std::min((width - 2 * sideMargin) / pattern.squaresX,
                                                  (height - 2 * topMargin) / pattern.squaresY)));
  }
  if (square < smallestSquare) {
    throw InputError{
        fmt::format("--squares {}x{}: expected few enough for squares of {:g} mm on {} paper, found squares "
                    "of {:g} mm; take fewer squares or larger paper",
                    pattern.squaresX, pattern.squaresY, smallestSquare, paper.name, square)};
  }
  pattern.squareLength = square / 1000;
  pattern.markerLength = 0.75 * pattern.squareLength;
  return pattern;
}

void addBoardSheet(PdfDocument& pdf, const Board& board, const Paper& paper) {
  requirePrintable(board);
  const Vector2d size = patternSize(*board.pattern), sheet = size + 2 * Vector2d{sideMargin, topMargin};
  const auto page = orientPaper(paper, sheet);
  if (!page) {
    throw InputError{
        fmt::format("board {}: expected paper of at least {:g} mm × {:g} mm, found {} paper of {:g} mm × {:g} "
                    "mm; take a larger one, smaller squares, or spread the board over several sheets with "
                    "--tile {}",
                    board.id, sheet.x(), sheet.y(), paper.name, paper.width, paper.height, paper.name)};
  }
  pdf.addPage(page->x(), page->y());
  pdf.setOrigin((*page - size) / 2);
  drawBoard(pdf, board);
}

std::size_t addBoardTiles(PdfDocument& pdf, const Board& board, const Paper& paper) {
  requirePrintable(board);
  const Tiling wide = tile(*board.pattern, {paper.width, paper.height}),
               high = tile(*board.pattern, {paper.height, paper.width});
  const bool isWide = wide.count() > 0 && (high.count() == 0 || wide.count() <= high.count());
  const Tiling& tiling = isWide ? wide : high;
  if (tiling.count() == 0) {
    throw InputError{
        fmt::format("board {}: expected squares that fit on {} paper, found squares of {:g} mm; take larger "
                    "sheets or smaller squares",
                    board.id, paper.name, millimetres(board.pattern->squareLength))};
  }
  for (std::size_t row = 0; row + 1 < tiling.ys.size(); ++row) {
    for (std::size_t column = 0; column + 1 < tiling.xs.size(); ++column) {
      addTile(pdf, board, tiling, column, row);
    }
  }
  return tiling.count();
}

} // namespace naocal
