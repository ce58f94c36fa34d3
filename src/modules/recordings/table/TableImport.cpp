#include "recordings/table/TableImport.hpp"

#include "io/Files.hpp"
#include "io/GreyImage.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "measurements/FailedReadings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

namespace naocal {

namespace {

constexpr double largestAngle = 4 * std::numbers::pi; // of a joint with limits [rad]
constexpr double largestDistance = 1000;              // from a tracker [m]
constexpr double quaternionTolerance = 0.01;          // of its length

/// "rows 7, 19, 25": counted from 1, the names' row included; the first twenty.
std::string listRows(const std::vector<std::size_t>& rows) {
  constexpr std::size_t most = 20;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < std::min(most, rows.size()); ++i) {
    numbers.push_back(rows[i] + 2);
  }
  return fmt::format("{} {}{}", rows.size() == 1 ? "row" : "rows", fmt::join(numbers, ", "),
                     rows.size() > most ? ", .." : "");
}

/// Columns of a recorded joint.
struct JointReader {
  std::string name;
  std::size_t column;
  std::optional<std::size_t> temperature; // column
  double factor;                          // to rad or m
  bool isLimited;                         // turns, within limits
  std::string unit;
};

class TableImporter {
public:
  TableImporter(const CsvTable& table, const ColumnMap& map, const ImportScene& scene, std::filesystem::path pictures)
      : table_{table}, map_{map}, scene_{scene}, pictures_{std::move(pictures)} {
    for (const Joint& joint : scene.robot.joints) { // in the order of the description
      if (const auto found = map.joints.find(joint.name); found != map.joints.end()) {
        joints_.push_back(makeReader(joint, found->second));
      }
    }
  }

  TableImport run() {
    std::vector<std::string> names;
    for (const JointReader& joint : joints_) {
      names.push_back(joint.name);
    }
    if (names.empty()) {
      throw InputError{fmt::format("{}: expected columns of joints, found none in the column map", table_.file())};
    }
    if (map_.image) {
      requireBoards(scene_);
    }
    TableImport result;
    result.rows = table_.rows();
    result.imported = beginImport(scene_, names);
    result.imported.files["columns.json"] = columnMapJson(map_).dump(2) + "\n";
    addInstruments(result);
    if (!map_.time) {
      result.guessed.emplace_back("no column gives the time: each row counts as one second, and rates are per row");
    }
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      Capture capture = readCapture(row, result.imported);
      if (capture.image.empty() && capture.points.empty() && capture.frames.empty()) {
        ++result.withoutMeasurement;
        result.passedOver.push_back(row);
      } else {
        result.imported.set.captures.push_back(std::move(capture));
        rows_.push_back(row);
      }
    }
    leaveOutFailed(result);
    if (result.imported.set.captures.empty()) {
      throw InputError{
          fmt::format("{}: expected rows with a picture, a measured point or a measured frame, found none; "
                      "say which columns they are with --columns",
                      table_.file())};
    }
    if (map_.image) {
      addCamera(scene_, scene_.lens, scene_.cameraLink, result.imported);
    }
    return result;
  }

private:
  /// Leaves out readings that are none, and captures in which nothing remains.
  void leaveOutFailed(TableImport& result) const {
    CaptureSet& set = result.imported.set;
    const std::vector<FailedReadings> failed = findFailedReadings(set, scene_.robot);
    for (const FailedReadings& one : failed) {
      std::vector<std::size_t> rows;
      for (const std::size_t capture : one.captures) {
        rows.push_back(rows_[capture]);
      }
      result.failed.push_back(describeFailedReadings(one, listRows(rows)));
    }
    removeFailedReadings(failed, set);
    std::erase_if(set.captures, [](const Capture& capture) {
      return capture.image.empty() && capture.points.empty() && capture.frames.empty();
    });
  }

  JointReader makeReader(const Joint& joint, const JointColumn& column) const {
    const double unit = joint.isPrismatic ? *metresPer(column.unit) : column.unit == "deg" ? radians(1.0) : 1;
    const auto temperature = map_.temperature.find(joint.name);
    return {joint.name,
            table_.column(column.column),
            temperature == map_.temperature.end() ? std::nullopt : std::optional{table_.column(temperature->second)},
            column.sign * column.factor * unit,
            !joint.isPrismatic && std::isfinite(joint.limits.upper - joint.limits.lower),
            column.unit};
  }

  /// The last link that the recorded joints move.
  std::string lastLink() const {
    const Robot& robot = scene_.robot;
    std::size_t last = robot.joints[*robot.jointIndex(joints_.back().name)].link;
    for (std::size_t link = last + 1; link < robot.links.size(); ++link) {
      if (robot.links[link].parent == last) { // fixed to it, such as a flange
        last = robot.links[link].joint ? last : link;
      }
    }
    return robot.links[last].name;
  }

  void addInstruments(TableImport& result) const {
    Instruments& instruments = result.imported.set.instruments;
    const auto addTracker = [&](const std::string& id) {
      const bool isKnown = std::any_of(instruments.trackers.begin(), instruments.trackers.end(),
                                       [&](const Tracker& tracker) { return tracker.id == id; });
      if (!isKnown) {
        Tracker tracker;
        tracker.id = id;
        instruments.trackers.push_back(tracker);
      }
    };
    for (const PointColumns& point : map_.points) {
      addTracker(point.tracker);
      TrackedMarker marker;
      marker.id = point.marker;
      marker.link = point.link.empty() ? guessLink("marker " + point.marker, result) : point.link;
      instruments.markers.push_back(marker);
    }
    for (const FrameColumns& frame : map_.frames) {
      addTracker(frame.tracker);
      instruments.frames.push_back(
          {frame.frame, frame.link.empty() ? guessLink("frame " + frame.frame, result) : frame.link, std::nullopt});
    }
  }

  std::string guessLink(const std::string& what, TableImport& result) const {
    std::string link = lastLink();
    result.guessed.push_back(fmt::format("{} was taken to be on link {}, the last that the joints move", what, link));
    return link;
  }

  Capture readCapture(std::size_t row, ImportedSet& imported) {
    Capture capture;
    capture.source = std::make_shared<const nlohmann::json>(nlohmann::json::object()); // recorded, though in no set yet
    capture.id = static_cast<int>(imported.set.captures.size());
    capture.supportFoot = SupportFoot::none;
    capture.time = Seconds{static_cast<double>(row)};
    if (map_.time) {
      capture.time = Seconds{readTime(row)};
    }
    for (const JointReader& joint : joints_) {
      capture.joints.measured.push_back(readAngle(row, joint));
      if (!map_.temperature.empty()) { // of all joints or of none
        const auto read = joint.temperature ? table_.number(row, *joint.temperature) : std::nullopt;
        capture.joints.temperature.push_back(read.value_or(std::nan("")));
      }
    }
    readPose(row, imported.set.captures, capture);
    readPositions(row, capture);
    readPicture(row, capture, imported);
    return capture;
  }

  double readTime(std::size_t row) {
    const std::size_t column = table_.column(*map_.time);
    const std::optional<double> time = table_.number(row, column);
    if (!time) {
      throw InputError{
          fmt::format("{}, column \"{}\": expected a time, found an empty cell", table_.where(row), *map_.time)};
    }
    if (!start_) {
      start_ = *time;
    }
    return (*time - *start_) * *secondsPer(map_.timeUnit);
  }

  double readAngle(std::size_t row, const JointReader& joint) const {
    const std::optional<double> cell = table_.number(row, joint.column);
    if (!cell) {
      return std::nan(""); // not recorded
    }
    const double angle = joint.factor * *cell;
    if (joint.isLimited && std::abs(angle) > largestAngle) {
      throw InputError{fmt::format("{}, column \"{}\": expected an angle of joint {} of at most two turns, found {} "
                                   "{}{}",
                                   table_.where(row), table_.names()[joint.column], joint.name, *cell, joint.unit,
                                   joint.unit == "rad" ? "; are these degrees? (\"unit\": \"deg\")" : "")};
    }
    return angle;
  }

  void readPose(std::size_t row, const std::vector<Capture>& before, Capture& capture) {
    const auto isSame = [&](const Capture& other) {
      return std::equal(capture.joints.measured.begin(), capture.joints.measured.end(), other.joints.measured.begin(),
                        [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
    };
    const bool isAsBefore = !before.empty() && isSame(before.back());
    if (!map_.pose) {
      capture.pose = isAsBefore ? before.back().pose : poseName(poses_++);
      return;
    }
    capture.pose = table_.text(row, table_.column(*map_.pose));
    if (capture.pose.empty()) {
      throw InputError{fmt::format("{}, column \"{}\": expected the name of a pose, found an empty cell",
                                   table_.where(row), *map_.pose)};
    }
    const auto last =
        std::find_if(before.rbegin(), before.rend(), [&](const Capture& other) { return other.pose == capture.pose; });
    const bool rests = isAsBefore && last == before.rbegin();
    if (map_.repeat) {
      capture.repeat = readRepeat(row);
    } else if (last != before.rend()) {
      capture.repeat = last->repeat + (rests ? 0 : 1);
    }
    // Other angles of one pose are other readings: a rest would give all its pictures their mean.
    if (last != before.rend()) {
      capture.repeatKind = rests || capture.repeat == last->repeat ? last->repeatKind : RepeatKind::reapproach;
    }
  }

  int readRepeat(std::size_t row) const {
    const std::optional<double> repeat = table_.number(row, table_.column(*map_.repeat));
    if (!repeat || *repeat < 0 || *repeat > 1e6 || *repeat != std::floor(*repeat)) {
      throw InputError{fmt::format("{}, column \"{}\": expected a number of a repeat, 0 to 1000000, found \"{}\"",
                                   table_.where(row), *map_.repeat,
                                   printableText(table_.text(row, table_.column(*map_.repeat)), 40))};
    }
    return static_cast<int>(*repeat);
  }

  /// Three coordinates in metres; absent if all cells are empty.
  std::optional<Eigen::Vector3d> readPosition(std::size_t row, const std::array<std::string, 3>& columns,
                                              const std::string& unit) const {
    Eigen::Vector3d position;
    int missing = 0;
    for (int i = 0; i < 3; ++i) {
      const std::string& name = columns[static_cast<std::size_t>(i)];
      const std::optional<double> cell = table_.number(row, table_.column(name));
      missing += cell ? 0 : 1;
      position[i] = cell.value_or(0) * *metresPer(unit);
      if (std::abs(position[i]) > largestDistance) {
        throw InputError{fmt::format("{}, column \"{}\": expected a coordinate of at most {} m, found {} {}{}",
                                     table_.where(row), name, largestDistance, *cell, unit,
                                     unit == "m" ? "; are these millimetres? (\"unit\": \"mm\")" : "")};
      }
    }
    if (missing == 3) {
      return std::nullopt;
    }
    if (missing > 0) {
      throw InputError{fmt::format("{}, columns \"{}\", \"{}\", \"{}\": expected three coordinates or none, found {}",
                                   table_.where(row), columns[0], columns[1], columns[2], 3 - missing)};
    }
    return position;
  }

  void readPositions(std::size_t row, Capture& capture) const {
    for (const PointColumns& point : map_.points) {
      if (const auto xyz = readPosition(row, point.columns, point.unit)) {
        capture.points.push_back({point.tracker, point.marker, *xyz});
      }
    }
    for (const FrameColumns& frame : map_.frames) {
      const auto xyz = readPosition(row, frame.columns, frame.unit);
      if (xyz && hasRotation(row, frame)) {
        capture.frames.push_back({frame.tracker, frame.frame, *xyz, readQuaternion(row, frame)});
      }
    }
  }

  /// False if all four numbers are 0, or none is given.
  bool hasRotation(std::size_t row, const FrameColumns& frame) const {
    return std::any_of(frame.quaternion.begin(), frame.quaternion.end(), [&](const std::string& name) {
      return table_.number(row, table_.column(name)).value_or(0) != 0;
    });
  }

  Eigen::Quaterniond readQuaternion(std::size_t row, const FrameColumns& frame) const {
    std::array<double, 4> parts{};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      parts[i] = table_.number(row, table_.column(frame.quaternion[i])).value_or(std::nan(""));
    }
    const Eigen::Quaterniond rotation{parts[0], parts[1], parts[2], parts[3]};
    if (!(std::abs(rotation.norm() - 1) < quaternionTolerance)) {
      throw InputError{fmt::format("{}, columns \"{}\" to \"{}\": expected a quaternion w, x, y, z of length 1, found "
                                   "length {:.3f}",
                                   table_.where(row), frame.quaternion.front(), frame.quaternion.back(),
                                   rotation.norm())};
    }
    return rotation.normalized();
  }

  void readPicture(std::size_t row, Capture& capture, ImportedSet& imported) const {
    if (!map_.image) {
      return;
    }
    const std::string& name = table_.text(row, table_.column(*map_.image));
    if (name.empty()) {
      return;
    }
    const std::string where = fmt::format("{}, column \"{}\"", table_.where(row), *map_.image);
    const std::optional<std::filesystem::path> file = fileInside(pictures_, name);
    if (!file || !std::filesystem::is_regular_file(*file)) {
      throw InputError{fmt::format("{}: expected a picture in {} (--pictures), found no file \"{}\" there", where,
                                   pictures_.string(), printableText(name, 200))};
    }
    imageSize(readFile(*file), where + ", " + printableText(name, 200));
    std::string extension = file->extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    capture.camera = scene_.camera;
    capture.image = fmt::format("images/{:04}{}", capture.id, extension);
    imported.copies[capture.image] = *file;
  }

  const CsvTable& table_;
  const ColumnMap& map_;
  const ImportScene& scene_;
  std::filesystem::path pictures_;
  std::vector<JointReader> joints_;
  std::optional<double> start_;   // time of the first row, in the table's unit
  std::size_t poses_ = 0;         // named so far
  std::vector<std::size_t> rows_; // of the captures
};

} // namespace

TableImport importTable(const CsvTable& table, const ColumnMap& map, const ImportScene& scene,
                        const std::filesystem::path& pictures) {
  return TableImporter{table, map, scene, pictures}.run();
}

std::vector<std::string> summarize(const TableImport& result) {
  std::vector<std::string> lines{fmt::format("{} rows, {} captures", result.rows, result.imported.set.captures.size())};
  if (result.withoutMeasurement > 0) {
    lines.push_back(fmt::format("{} rows passed over: no picture, no measured position ({})", result.withoutMeasurement,
                                listRows(result.passedOver)));
  }
  lines.insert(lines.end(), result.guessed.begin(), result.guessed.end());
  lines.insert(lines.end(), result.failed.begin(), result.failed.end());
  return lines;
}

} // namespace naocal
