#include "evaluation/thesis/ThesisFiles.hpp"

#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <sstream>
#include <tuple>

namespace naocal {

namespace {

/// Joints of the thesis's own program, in the order of its files: head, left arm, left leg, right leg, right arm.
constexpr std::array<std::string_view, 26> programOrder{
    "HeadYaw",       "HeadPitch",    "LShoulderPitch", "LShoulderRoll", "LElbowYaw",   "LElbowRoll",  "LWristYaw",
    "LHand",         "LHipYawPitch", "LHipRoll",       "LHipPitch",     "LKneePitch",  "LAnklePitch", "LAnkleRoll",
    "RHipYawPitch",  "RHipRoll",     "RHipPitch",      "RKneePitch",    "RAnklePitch", "RAnkleRoll",  "RShoulderPitch",
    "RShoulderRoll", "RElbowYaw",    "RElbowRoll",     "RWristYaw",     "RHand"};

constexpr std::size_t mostRows = 1'000'000, mostPoints = 100'000;
constexpr std::array<std::string_view, 4> statusWords{"solverFailure", "noConvergence", "localMinimum", "success"};

/// A line of a file, split at `separator` (a blank: any white space).
struct Line {
  std::string place; // "errors.csv: line 3"
  std::vector<std::string> cells;
};

[[noreturn]] void refuse(const std::string& place, std::string_view expected, std::string_view found) {
  throw InputError{fmt::format("{}: expected {}, found {}", place, expected, printableText(found, 60))};
}

std::vector<std::string> splitLine(const std::string& text, bool byCommas) {
  std::vector<std::string> cells;
  std::istringstream stream{text};
  std::string cell;
  if (!byCommas) {
    while (stream >> cell) {
      cells.push_back(cell);
    }
    return cells;
  }
  while (std::getline(stream, cell, ',')) {
    const std::size_t first = cell.find_first_not_of(" \t"), last = cell.find_last_not_of(" \t");
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  if (text.ends_with(',')) {
    cells.emplace_back();
  }
  return cells;
}

/// Lines with content, without comments; by commas if the first one has any.
std::vector<Line> readLines(const std::filesystem::path& file) {
  constexpr std::uintmax_t mostBytes = 300'000'000;
  std::istringstream stream{readFile(file, mostBytes)};
  std::vector<Line> lines;
  std::optional<bool> byCommas;
  std::string text;
  for (std::size_t number = 1; std::getline(stream, text); ++number) {
    if (text.ends_with('\r')) {
      text.pop_back();
    }
    if (text.starts_with('#') || text.find_first_not_of(" \t") == std::string::npos) {
      continue;
    }
    byCommas = byCommas.value_or(text.find(',') != std::string::npos);
    lines.push_back({fmt::format("{}: line {}", file.string(), number), splitLine(text, *byCommas)});
    if (lines.size() > mostRows) {
      refuse(file.string(), fmt::format("at most {} rows", mostRows), "more");
    }
  }
  if (lines.empty()) {
    refuse(file.string(), "rows of numbers", "none");
  }
  return lines;
}

double numberAt(const Line& line, std::size_t cell, double most) {
  const std::string& text = line.cells[cell];
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(std::abs(value) <= most)) {
    refuse(line.place, fmt::format("a number between {} and {} in column {}", -most, most, cell + 1),
           text.empty() ? "nothing" : text);
  }
  return value;
}

int countAt(const Line& line, std::size_t cell) {
  constexpr double most = 300;
  const double count = numberAt(line, cell, most);
  if (count < 1 || count != std::floor(count)) {
    refuse(line.place, fmt::format("a whole number from 1 to {} in column {}", most, cell + 1), line.cells[cell]);
  }
  return static_cast<int>(count);
}

void requireCells(const Line& line, std::size_t count) {
  if (line.cells.size() != count) {
    refuse(line.place, fmt::format("{} columns", count), fmt::format("{}", line.cells.size()));
  }
}

/// Column of each name, from the line that names the columns.
std::vector<std::size_t> columnsOf(const Line& heads, const JointColumns& columns) {
  for (const std::string& head : heads.cells) {
    if (!columns.robot.jointIndex(head)) {
      refuse(heads.place, "names of joints, such as HeadYaw,HeadPitch,LHipYawPitch", head.empty() ? "nothing" : head);
    }
    if (std::count(heads.cells.begin(), heads.cells.end(), head) > 1) {
      refuse(heads.place, "every joint once", head + " twice");
    }
  }
  std::vector<std::size_t> result;
  for (const std::string& name : columns.names) {
    const auto found = std::find(heads.cells.begin(), heads.cells.end(), name);
    if (found == heads.cells.end()) {
      refuse(heads.place, fmt::format("a column {}", name), "none");
    }
    result.push_back(static_cast<std::size_t>(found - heads.cells.begin()));
  }
  return result;
}

/// Rows of a CSV file whose first line names joints.
std::vector<Eigen::VectorXd> jointRows(const std::vector<Line>& lines, const JointColumns& columns) {
  const std::vector<std::size_t> cells = columnsOf(lines.front(), columns);
  std::vector<Eigen::VectorXd> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    requireCells(lines[i], lines.front().cells.size());
    Eigen::VectorXd& row = rows.emplace_back(eigenIndex(cells.size()));
    for (std::size_t joint = 0; joint < cells.size(); ++joint) {
      row[eigenIndex(joint)] = numberAt(lines[i], cells[joint], columns.range);
    }
  }
  if (rows.empty()) {
    refuse(lines.front().place, "rows below the names of the joints", "none");
  }
  return rows;
}

/// The numbers of one line of the thesis's program, all joints from cell `first` on.
Eigen::VectorXd programRow(const Line& line, std::size_t first, const JointColumns& columns) {
  Eigen::VectorXd row(eigenIndex(columns.names.size()));
  for (std::size_t i = 0; i < columns.names.size(); ++i) {
    const auto joint = std::find(programOrder.begin(), programOrder.end(), columns.names[i]) - programOrder.begin();
    row[eigenIndex(i)] = numberAt(line, first + static_cast<std::size_t>(joint), columns.range);
  }
  return row;
}

bool isNumber(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789+-.eE") == std::string::npos;
}

/// A feature of the thesis's program: "GroundGrid side spacing x y yaw" [m, rad], or "ChessBoardPatternOnFloor columns
/// rows spacing x y yaw" [m, degrees].
FloorPattern programFeature(const Line& line) {
  constexpr double far = 100; // [m]
  if (line.cells.front() == "GroundGrid") {
    requireCells(line, 6);
    const auto side = countAt(line, 1);
    return {side, side, numberAt(line, 2, far), numberAt(line, 3, far), numberAt(line, 4, far), numberAt(line, 5, 7)};
  }
  if (line.cells.front() == "ChessBoardPatternOnFloor") {
    requireCells(line, 7);
    return {countAt(line, 1),       countAt(line, 2),       numberAt(line, 3, far),
            numberAt(line, 4, far), numberAt(line, 5, far), radians(numberAt(line, 6, 360))};
  }
  refuse(line.place, "columns,rows,spacing,x,y,yaw, or GroundGrid or ChessBoardPatternOnFloor of the thesis's program",
         line.cells.front());
}

constexpr std::string_view featureColumns = "columns,rows,spacing,x,y,yaw";

std::string joined(const Eigen::VectorXd& numbers) {
  return fmt::format("{:.9g}", fmt::join(numbers.begin(), numbers.end(), ","));
}

} // namespace

std::vector<Eigen::VectorXd> readErrorSets(const std::filesystem::path& file, const JointColumns& columns) {
  const std::vector<Line> lines = readLines(file);
  if (!isNumber(lines.front().cells.front())) {
    return jointRows(lines, columns);
  }
  std::vector<Eigen::VectorXd> rows;
  for (const Line& line : lines) {
    requireCells(line, programOrder.size());
    rows.push_back(-programRow(line, 0, columns)); // the program adds its errors to readings
  }
  return rows;
}

std::vector<Eigen::VectorXd> readPoses(const std::filesystem::path& file, const JointColumns& columns) {
  constexpr std::size_t before = 19; // cells before the angles
  const std::vector<Line> lines = readLines(file);
  if (lines.front().cells.front() != "NaoPoseAndRawAngles") {
    return jointRows(lines, columns);
  }
  std::vector<Eigen::VectorXd> rows;
  for (const Line& line : lines) {
    requireCells(line, before + programOrder.size());
    if (line.cells[3] != "1") {
      refuse(line.place, "the left support foot (1) in column 4", line.cells[3]);
    }
    rows.push_back(programRow(line, before, columns));
  }
  return rows;
}

std::vector<FloorPattern> readFeatures(const std::filesystem::path& file) {
  const std::vector<Line> lines = readLines(file);
  const bool isTable = fmt::format("{}", fmt::join(lines.front().cells, ",")) == featureColumns;
  std::vector<FloorPattern> features;
  int points = 0;
  for (std::size_t i = isTable ? 1 : 0; i < lines.size(); ++i) {
    const Line& line = lines[i];
    if (isTable) {
      requireCells(line, 6);
      features.push_back({countAt(line, 0), countAt(line, 1), numberAt(line, 2, 100), numberAt(line, 3, 100),
                          numberAt(line, 4, 100), numberAt(line, 5, 7)});
    } else {
      features.push_back(programFeature(line));
    }
    if (features.back().spacing <= 0) {
      refuse(line.place, "a positive spacing", fmt::format("{}", features.back().spacing));
    }
    points += features.back().columns * features.back().rows;
    if (points > static_cast<int>(mostPoints)) {
      refuse(line.place, fmt::format("at most {} points in all", mostPoints), "more");
    }
  }
  if (features.empty()) {
    refuse(lines.front().place, "rows below the names of the columns", "none");
  }
  return features;
}

std::string formatJointTable(std::string_view kind, const std::vector<std::string>& names,
                             const std::vector<Eigen::VectorXd>& rows) {
  std::string text = fmt::format("{}\n{}\n", kind, fmt::join(names, ","));
  for (const Eigen::VectorXd& row : rows) {
    text += fmt::format("{}\n", fmt::join(row.begin(), row.end(), ",")); // to the last bit
  }
  return text;
}

std::string formatFeatures(const std::vector<FloorPattern>& features) {
  std::string text = fmt::format("{}\n{}\n", featuresKind, featureColumns);
  for (const FloorPattern& each : features) {
    text += fmt::format("{},{},{},{},{},{}\n", each.columns, each.rows, each.spacing, each.x, each.y, each.yaw);
  }
  return text;
}

std::string formatRows(std::vector<ThesisRow> rows, const std::vector<std::string>& names, double tolerance) {
  const auto key = [](const ThesisRow& row) { return std::tuple{row.setting.key(), row.set, row.solver}; };
  std::sort(rows.begin(), rows.end(),
            [&](const ThesisRow& one, const ThesisRow& other) { return key(one) < key(other); });
  std::string text = fmt::format("{}\nfeature,poses,noise,jointNoise,samples,solver,set,status,calibrationRmsPx,"
                                 "testErrorPx,residual {},injected {}\n",
                                 rowsKind, fmt::join(names, ",residual "), fmt::join(names, ",injected "));
  for (const ThesisRow& row : rows) {
    const ThesisSetting& setting = row.setting;
    const ThesisSolution& solution = row.solution;
    const std::string none(names.size() - 1, ',');
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", toString(setting.feature), setting.poses,
                        toString(setting.noise), setting.angleNoise() ? toString(setting.jointNoise) : "none",
                        setting.samples, toString(row.solver), row.set,
                        statusWords[static_cast<std::size_t>(solution.status(tolerance))],
                        solution.solved ? fmt::format("{:.6g}", solution.rms) : "",
                        solution.heldOut ? fmt::format("{:.6g}", solution.heldOut->mean) : "",
                        solution.solved ? joined(solution.errors) : none, joined(row.offsets));
  }
  return text;
}

} // namespace naocal
