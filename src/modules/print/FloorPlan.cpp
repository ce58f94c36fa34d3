#include "print/FloorPlan.hpp"

#include "math/Angles.hpp"
#include "poses/PoseFile.hpp"
#include "poses/candidates/BoardPlacement.hpp"
#include "robot/Balance.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace naocal {

namespace {

using Eigen::Vector2d;

constexpr double pageWidth = 210, pageHeight = 297, margin = 15; // A4 [mm]
constexpr PageBox drawing{margin, 31, pageWidth - 2 * margin, 150};
constexpr double axisRoom = 34; // beside and below the boards, for dimension lines [mm]
constexpr PageColour ink{0.1, 0.1, 0.12}, soft{0.45, 0.45, 0.5}, grid{0.88, 0.88, 0.9}, squareTint{0.8, 0.83, 0.88},
    boardTint{0.96, 0.97, 0.99}, dimension{0.1, 0.35, 0.65}, footTint{0.97, 0.86, 0.68}, liftedTint{0.96, 0.96, 0.96},
    band{0.95, 0.95, 0.96};

/// A board's pattern corner in the sole's frame; `across`, `down`: 0 or 1, from the top left corner.
Vector2d patternCorner(const Board& board, double across, double down) {
  const CharucoPattern pattern = board.pattern.value_or(CharucoPattern{});
  const Vector2d onBoard = pattern.squareLength * Vector2d{across * pattern.squaresX, -down * pattern.squaresY};
  return Vector2d{board.placement->x, board.placement->y} + Eigen::Rotation2Dd{board.placement->yaw} * onBoard;
}

std::vector<Vector2d> outlineOf(const Board& board) {
  return board.pattern ? std::vector<Vector2d>{patternCorner(board, 0, 0), patternCorner(board, 0, 1),
                                               patternCorner(board, 1, 1), patternCorner(board, 1, 0)}
                       : boardOutline(board, 0.01);
}

/// Soles on the floor in the support sole's frame: the one that stands, and the other one beside it.
struct Feet {
  std::vector<Vector2d> standing, other;
};

Feet feetOf(const PosePlan& plan, const Robot& robot) {
  Feet feet{supportSole(robot, plan.supportFoot).outline, otherSole(robot, plan.supportFoot).outline};
  for (Vector2d& corner : feet.other) {
    corner.y() += 2 * midlineBetweenFeet(plan.supportFoot);
  }
  return feet;
}

/// Maps the floor, x ahead and y to the left [m], onto the page: ahead is up.
struct FloorScale {
  double denominator = 10; // 1:denominator
  Vector2d origin;         // of the floor on the page [mm]

  double perMetre() const { return 1000 / denominator; }
  Vector2d operator()(const Vector2d& floor) const { return origin - perMetre() * Vector2d{floor.y(), floor.x()}; }
  std::vector<Vector2d> operator()(std::vector<Vector2d> floor) const {
    for (Vector2d& point : floor) {
      point = (*this)(point);
    }
    return floor;
  }
};

/// Floor that the drawing has to show [m].
Eigen::AlignedBox2d extentOf(const PosePlan& plan, const Feet& feet) {
  Eigen::AlignedBox2d extent;
  const auto add = [&](const std::vector<Vector2d>& corners) {
    for (const Vector2d& corner : corners) {
      extent.extend(corner);
    }
  };
  add(feet.standing);
  add(feet.other);
  for (const Board& board : plan.boards) {
    add(outlineOf(board));
  }
  return extent;
}

FloorScale fitScale(const Eigen::AlignedBox2d& extent) {
  const Vector2d room{drawing.width - axisRoom, drawing.height - axisRoom};
  const double wanted = std::max(extent.sizes().y() / room.x(), extent.sizes().x() / room.y()) * 1000;
  constexpr std::array denominators{5.0,  7.5,  10.0, 12.5, 15.0,  20.0,  25.0,
                                    30.0, 40.0, 50.0, 75.0, 100.0, 200.0, 500.0};
  const auto* const fitting =
      std::find_if(denominators.begin(), denominators.end(), [&](double d) { return d >= wanted; });
  FloorScale scale{fitting == denominators.end() ? wanted : *fitting, Vector2d::Zero()};
  const Vector2d centre = extent.center();
  scale.origin = Vector2d{drawing.x + room.x() / 2, drawing.y + room.y() / 2} +
                 scale.perMetre() * Vector2d{centre.y(), centre.x()};
  return scale;
}

void drawGrid(PdfDocument& pdf, const FloorScale& scale, const Eigen::AlignedBox2d& extent) {
  const auto steps = [](double from, double to) {
    return std::pair{static_cast<int>(std::floor(10 * from)), static_cast<int>(std::ceil(10 * to))};
  };
  const auto [back, front] = steps(extent.min().x(), extent.max().x());
  const auto [right, left] = steps(extent.min().y(), extent.max().y());
  for (int i = back; i <= front; ++i) {
    pdf.drawLine(scale({0.1 * i, 0.1 * left}), scale({0.1 * i, 0.1 * right}), i % 5 == 0 ? 0.25 : 0.1, grid);
  }
  for (int i = right; i <= left; ++i) {
    pdf.drawLine(scale({0.1 * back, 0.1 * i}), scale({0.1 * front, 0.1 * i}), i % 5 == 0 ? 0.25 : 0.1, grid);
  }
}

void drawBoard(PdfDocument& pdf, const FloorScale& scale, const Board& board) {
  pdf.fillPolygon(scale(outlineOf(board)), boardTint);
  if (const auto& pattern = board.pattern) {
    for (int row = 0; row < pattern->squaresY; ++row) {
      for (int column = 0; column < pattern->squaresX; ++column) {
        if (isBlackSquare(*pattern, column, row)) {
          const double left = double(column) / pattern->squaresX, right = double(column + 1) / pattern->squaresX,
                       top = double(row) / pattern->squaresY, bottom = double(row + 1) / pattern->squaresY;
          pdf.fillPolygon(scale({patternCorner(board, left, top), patternCorner(board, right, top),
                                 patternCorner(board, right, bottom), patternCorner(board, left, bottom)}),
                          squareTint);
        }
      }
    }
  }
  pdf.drawPolygon(scale(outlineOf(board)), 0.35, ink);
  Vector2d centre = Vector2d::Zero();
  for (const Vector2d& corner : outlineOf(board)) {
    centre += corner / double(outlineOf(board).size());
  }
  // Written as on the board: upright if the pattern's upper edge points to the left of the robot.
  pdf.write(scale(centre) + Vector2d{0, 3}, board.id,
            {.size = 8, .align = TextAlign::centre, .bold = true, .colour = ink});
}

/// Marks the corner that distances refer to, and the second one along the pattern's upper edge.
void markCorners(PdfDocument& pdf, const FloorScale& scale, const Board& board) {
  constexpr double radius = 1.1;
  const Vector2d first = scale(patternCorner(board, 0, 0)), second = scale(patternCorner(board, 1, 0));
  std::vector<Vector2d> disc;
  for (int i = 0; i < 24; ++i) {
    disc.push_back(first + radius * Vector2d{std::cos(i * std::numbers::pi / 12), std::sin(i * std::numbers::pi / 12)});
  }
  pdf.fillPolygon(disc, dimension);
  pdf.drawCircle(second, radius, 0.4, dimension);
}

/// An arrow head at `tip`, pointing along `direction`.
void drawArrowHead(PdfDocument& pdf, const Vector2d& tip, const Vector2d& direction, const PageColour& colour) {
  constexpr double length = 2, half = 0.6;
  const Vector2d along = length * direction.normalized(), aside = half * Vector2d{-along.y(), along.x()} / length;
  pdf.fillPolygon({tip, tip - along + aside, tip - along - aside}, colour);
}

void drawFeet(PdfDocument& pdf, const FloorScale& scale, const Feet& feet, SupportFoot foot) {
  const bool onBoth = foot == SupportFoot::both;
  pdf.fillPolygon(scale(feet.other), onBoth ? footTint : liftedTint);
  pdf.drawPolygon(scale(feet.other), 0.15, onBoth ? ink : soft);
  pdf.fillPolygon(scale(feet.standing), footTint);
  pdf.drawPolygon(scale(feet.standing), 0.35, ink);
  const Vector2d origin = scale(Vector2d::Zero());
  pdf.drawLine(origin - Vector2d{2.2, 0}, origin + Vector2d{2.2, 0}, 0.3, dimension);
  pdf.drawLine(origin - Vector2d{0, 2.2}, origin + Vector2d{0, 2.2}, 0.3, dimension);
  pdf.drawCircle(origin, 1.1, 0.3, dimension);
}

/// Distances from the foot to the corners, drawn as dimension lines beside (ahead) and below (left and right).
void drawDimensions(PdfDocument& pdf, const FloorScale& scale, const PosePlan& plan,
                    const Eigen::AlignedBox2d& extent) {
  constexpr double step = 6.5, gap = 7, textSize = 2.7;
  const double rightEdge = scale({0, extent.min().y()}).x(), lowerEdge = scale({extent.min().x(), 0}).y();
  const Vector2d foot = scale(Vector2d::Zero());
  std::vector<Board> boards = plan.boards;
  const auto most = static_cast<std::size_t>((axisRoom - gap) / step); // more would leave the page
  boards.resize(std::min(boards.size(), most));
  std::vector<const Board*> order;
  for (const Board& board : boards) {
    order.push_back(&board);
  }
  std::sort(order.begin(), order.end(),
            [](const Board* a, const Board* b) { return std::abs(a->placement->x) < std::abs(b->placement->x); });
  const double axisRight = rightEdge + gap + step * (double(order.size()) - 0.5),
               axisBelow = lowerEdge + gap + step * (double(order.size()) - 0.5);
  pdf.drawLine(foot, {axisRight, foot.y()}, 0.15, dimension, 1.2);
  pdf.drawLine(foot, {foot.x(), axisBelow}, 0.15, dimension, 1.2);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Vector2d corner = scale(patternCorner(*order[i], 0, 0));
    const double x = rightEdge + gap + step * double(i);
    pdf.drawLine(corner, {x + 1.5, corner.y()}, 0.1, dimension, 0.7);
    pdf.drawLine({x, foot.y()}, {x, corner.y()}, 0.2, dimension);
    drawArrowHead(pdf, {x, corner.y()}, {0, corner.y() - foot.y()}, dimension);
    pdf.write({x - 0.8, (foot.y() + corner.y()) / 2},
              fmt::format("{}  {:.2f} m", order[i]->id, std::abs(order[i]->placement->x)),
              {.size = textSize, .align = TextAlign::centre, .turn = std::numbers::pi / 2, .colour = dimension});
  }
  std::sort(order.begin(), order.end(),
            [](const Board* a, const Board* b) { return std::abs(a->placement->y) < std::abs(b->placement->y); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Vector2d corner = scale(patternCorner(*order[i], 0, 0));
    const double y = lowerEdge + gap + step * double(i);
    pdf.drawLine(corner, {corner.x(), y + 1.5}, 0.1, dimension, 0.7);
    pdf.drawLine({foot.x(), y}, {corner.x(), y}, 0.2, dimension);
    drawArrowHead(pdf, {corner.x(), y}, {corner.x() - foot.x(), 0}, dimension);
    const std::string text = fmt::format("{}  {:.2f} m", order[i]->id, std::abs(order[i]->placement->y));
    const bool fits = pdf.textWidth(text, textSize) + 3 < std::abs(corner.x() - foot.x());
    const bool isLeft = corner.x() < foot.x();
    const Vector2d at =
        fits ? Vector2d{(foot.x() + corner.x()) / 2, y - 0.8} : Vector2d{foot.x() + (isLeft ? 1.5 : -1.5), y + 1};
    pdf.write(at, text,
              {.size = textSize,
               .align = fits     ? TextAlign::centre
                        : isLeft ? TextAlign::left
                                 : TextAlign::right,
               .colour = dimension});
  }
}

void drawScaleBar(PdfDocument& pdf, const FloorScale& scale) {
  const double half = scale.denominator <= 20 ? 0.25 : 1; // [m]
  const Vector2d from{drawing.x, drawing.bottom() + 5};
  const double part = half * scale.perMetre();
  pdf.fill({{from.x(), from.y(), part, 1.6}}, ink);
  pdf.drawPolygon({from, from + Vector2d{2 * part, 0}, from + Vector2d{2 * part, 1.6}, from + Vector2d{0, 1.6}}, 0.2,
                  ink);
  for (int i = 0; i <= 2; ++i) {
    pdf.write(from + Vector2d{i * part, 4.8}, fmt::format("{:g}{}", i * half, i == 2 ? " m" : ""),
              {.size = 2.7, .align = i == 0 ? TextAlign::left : TextAlign::centre, .colour = ink});
  }
  pdf.write(from + Vector2d{2 * part + 8, 1.6},
            fmt::format("scale 1:{:g}, if printed at 100 %;  the grid's lines lie 0.1 m apart", scale.denominator),
            {.size = 2.7, .colour = soft});
}

/// A table with its head; rows go on over further pages.
class Table {
public:
  struct Column {
    double x; // [mm]
    std::string head;
    TextAlign align = TextAlign::left;
  };

  Table(PdfDocument& pdf, double y, std::vector<Column> columns) : pdf_{pdf}, y_{y}, columns_{std::move(columns)} {
    writeHead();
  }

  void addRow(const std::vector<std::string>& texts) {
    if (y_ + height > pageHeight - margin) {
      pdf_.addPage(pageWidth, pageHeight);
      y_ = margin + height;
      writeHead();
    }
    if (++rows_ % 2 == 0) {
      pdf_.fill({{margin, y_ - height + 1.4, pageWidth - 2 * margin, height}}, band);
    }
    for (std::size_t i = 0; i < texts.size(); ++i) {
      pdf_.write({columns_[i].x, y_}, texts[i], {.size = 3, .align = columns_[i].align, .bold = i == 0, .colour = ink});
    }
    y_ += height;
  }

  double below() const { return y_; }

private:
  static constexpr double height = 5;

  void writeHead() {
    for (const Column& column : columns_) {
      pdf_.write({column.x, y_}, column.head, {.size = 2.7, .align = column.align, .colour = soft});
    }
    pdf_.drawLine({margin, y_ + 1.4}, {pageWidth - margin, y_ + 1.4}, 0.2, soft);
    y_ += height;
  }

  PdfDocument& pdf_;
  double y_;
  std::size_t rows_ = 0;
  std::vector<Column> columns_;
};

std::string sideways(double y) {
  return fmt::format("{:.2f} {}", std::abs(y), y >= 0 ? "left" : "right");
}

double writeBoards(PdfDocument& pdf, const PosePlan& plan, double y) {
  Table table{pdf,
              y,
              {{margin + 1, "board"},
               {50, "first corner: ahead", TextAlign::right},
               {71, "aside [m]", TextAlign::right},
               {92, "from foot", TextAlign::right},
               {123, "second: ahead", TextAlign::right},
               {141, "aside [m]", TextAlign::right},
               {158, "from foot", TextAlign::right},
               {pageWidth - margin - 1, "may be off by", TextAlign::right}}};
  for (std::size_t i = 0; i < plan.boards.size(); ++i) {
    const Vector2d first = patternCorner(plan.boards[i], 0, 0), second = patternCorner(plan.boards[i], 1, 0);
    const std::string tolerance =
        i < plan.tolerances.size()
            ? fmt::format("{:.0f} cm, {:.0f}°", 100 * plan.tolerances[i].shift, degrees(plan.tolerances[i].turn))
            : "";
    table.addRow({plan.boards[i].id, fmt::format("{:.2f}", first.x()), sideways(first.y()),
                  fmt::format("{:.2f}", first.norm()), fmt::format("{:.2f}", second.x()), sideways(second.y()),
                  fmt::format("{:.2f}", second.norm()), tolerance});
  }
  return table.below();
}

std::string footName(SupportFoot foot) {
  return foot == SupportFoot::both ? "both feet" : foot == SupportFoot::left ? "the left foot" : "the right foot";
}

/// "top: A, B; bottom: C": what a pose's pictures show of the boards.
std::string observations(const PlannedPose& pose) {
  std::map<std::string, std::set<std::string>> byCamera;
  for (const VisibleBoard& sight : pose.sights) {
    byCamera[sight.camera].insert(sight.board);
  }
  std::vector<std::string> parts;
  for (auto camera = byCamera.rbegin(); camera != byCamera.rend(); ++camera) {
    parts.push_back(fmt::format("{}: {}", camera->first, fmt::join(camera->second, ", ")));
  }
  return fmt::format("{}", fmt::join(parts, ";  "));
}

void writePoses(PdfDocument& pdf, const PosePlan& plan, double y) {
  Table table{pdf, y, {{margin + 1, "pose"}, {40, "stands on"}, {85, "way there", TextAlign::right}, {95, "observes"}}};
  for (std::size_t i = 0; i < plan.poses.size(); ++i) {
    const PlannedPose& pose = plan.poses[i].pose;
    const auto& way = plan.ways[i];
    table.addRow({poseId(plan.poses[i], i), footName(pose.supportFoot),
                  way ? fmt::format("{:.1f} s{}", way->seconds, way->via.empty() ? "" : ", round")
                      : (i == 0 ? "" : "from the stand"),
                  observations(pose)});
  }
}

void writeTitle(PdfDocument& pdf, const PosePlan& plan, const Robot& robot) {
  const bool alternates = std::any_of(plan.poses.begin(), plan.poses.end(), [&](const ProposedPose& each) {
    return each.pose.supportFoot != plan.supportFoot;
  });
  pdf.write({margin, 20}, "Where to lay the boards", {.size = 6.5, .bold = true, .colour = ink});
  pdf.write(
      {margin, 26},
      fmt::format("NAO {}, {} poses on {}. Seen from above, the robot faces up. Distances [m] from the cross under the "
                  "ankle of its {} foot.",
                  robot.model, plan.poses.size(), alternates ? "each foot in turn" : footName(plan.supportFoot),
                  plan.supportFoot == SupportFoot::right ? "right" : "left"),
      {.size = 3, .colour = soft});
}

void writeLegend(PdfDocument& pdf, double y) {
  pdf.write(
      {margin, y},
      "First corner: filled dot, the pattern's upper left corner. Second: open circle, the upper right one. From foot: "
      "the straight distance, to check with a tape.",
      {.size = 2.6, .colour = soft});
}

} // namespace

void addFloorPlan(PdfDocument& pdf, const PosePlan& plan, const Robot& robot) {
  const Feet feet = feetOf(plan, robot);
  const Eigen::AlignedBox2d extent = extentOf(plan, feet);
  const FloorScale scale = fitScale(extent);
  pdf.addPage(pageWidth, pageHeight);
  writeTitle(pdf, plan, robot);
  drawGrid(pdf, scale, extent);
  drawFeet(pdf, scale, feet, plan.supportFoot);
  for (const Board& board : plan.boards) {
    drawBoard(pdf, scale, board);
  }
  drawDimensions(pdf, scale, plan, extent);
  for (const Board& board : plan.boards) {
    markCorners(pdf, scale, board);
  }
  drawScaleBar(pdf, scale);
  const double below = writeBoards(pdf, plan, drawing.bottom() + 18);
  writeLegend(pdf, below);
  writePoses(pdf, plan, below + 10);
}

} // namespace naocal
