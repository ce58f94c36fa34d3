#include "recordings/table/ColumnGuess.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>
#include <set>

namespace naocal {

namespace {

constexpr double largestTurn = 2 * std::numbers::pi; // of a reading in radians [rad]
constexpr double largestReach = 20;                  // of a coordinate in metres [m]

/// A column's name in words: "Q1 [deg]" is {"q1", "deg"}.
std::vector<std::string> wordsOf(const std::string& name) {
  std::vector<std::string> words;
  bool isInside = false;
  for (const char letter : name) {
    const auto code = static_cast<unsigned char>(letter);
    if (std::isalnum(code) == 0) {
      isInside = false;
      continue;
    }
    if (!isInside) {
      words.emplace_back();
    }
    isInside = true;
    words.back() += static_cast<char>(std::tolower(code));
  }
  return words;
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, "_"));
}

/// A column without the unit at the end of its name.
struct NamedColumn {
  std::string name;               // as in the table
  std::vector<std::string> words; // of the rest
  std::string unit;               // empty: none
};

std::string unitOf(const std::string& word) {
  static const std::map<std::string, std::string> units{
      {"deg", "deg"},     {"degree", "deg"}, {"degrees", "deg"}, {"rad", "rad"}, {"radian", "rad"},
      {"radians", "rad"}, {"m", "m"},        {"mm", "mm"},       {"cm", "cm"},   {"s", "s"},
      {"sec", "s"},       {"ms", "ms"},      {"us", "us"},       {"ns", "ns"}};
  const auto found = units.find(word);
  return found == units.end() ? "" : found->second;
}

NamedColumn nameColumn(const std::string& name) {
  NamedColumn column{name, wordsOf(name), ""};
  if (column.words.size() > 1) {
    column.unit = unitOf(column.words.back());
    if (!column.unit.empty()) {
      column.words.pop_back();
    }
  }
  return column;
}

/// Words that say that a column was measured, and not what.
const std::set<std::string> measuredWords{"actual", "measured", "meas", "current", "real"};

/// "q1", "joint_2", "theta3", "axis 4", "actual_q_0": the number behind a usual word for joints.
std::optional<int> jointNumber(const NamedColumn& column) {
  const bool isMeasured = column.words.size() > 1 && measuredWords.contains(column.words.front());
  const std::string name =
      fmt::format("{}", fmt::join(column.words.begin() + (isMeasured ? 1 : 0), column.words.end(), ""));
  const auto digit = std::find_if(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  static const std::set<std::string> usual{"q",     "j",          "joint", "theta",         "axis",     "a",
                                           "angle", "jointangle", "jnt",   "jointposition", "position", "pos"};
  const std::string number{digit, name.end()};
  const bool isNumber = !number.empty() && number.size() < 4 &&
                        std::all_of(number.begin(), number.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  if (!isNumber || !usual.contains(std::string{name.begin(), digit})) {
    return std::nullopt;
  }
  return std::stoi(number);
}

bool isPictureName(const std::string& cell) {
  static const std::set<std::string> usual{"png", "jpg", "jpeg"};
  const std::vector<std::string> words = wordsOf(cell);
  return words.size() > 1 && usual.contains(words.back());
}

/// Of times since 1970, or since a start within the last months.
std::string timeUnitOf(double largest) {
  return largest > 1e17 ? "ns" : largest > 1e14 ? "us" : largest > 1e11 ? "ms" : "s";
}

class Guesser {
public:
  Guesser(const CsvTable& table, const Robot& robot) : table_{table}, robot_{robot} {
    std::set<std::string> known;
    for (const std::string& name : table.names()) {
      if (known.insert(name).second) {
        columns_.push_back(nameColumn(name));
      }
    }
  }

  ColumnGuess run() {
    guessNamedJoints();
    if (map_.joints.empty()) {
      guessNumberedJoints();
    }
    if (map_.joints.empty()) {
      refuseWithoutJoints();
    }
    guessMeasuredPositions();
    if (map_.points.empty() && map_.frames.empty()) {
      guessNumberedPosition();
    }
    guessOthers();
    ColumnGuess guess{std::move(map_), {}};
    for (const NamedColumn& column : columns_) {
      if (!used_.contains(column.name)) {
        guess.unused.push_back(column.name);
      }
    }
    return guess;
  }

private:
  [[noreturn]] void refuseWithoutJoints() const {
    std::vector<std::string> names;
    for (const Joint& joint : robot_.joints) {
      names.push_back(joint.name);
    }
    throw InputError{fmt::format("{}, row 1: expected columns named as the URDF's joints ({}) or q1, q2, .., found {}; "
                                 "say which columns are joints with --columns",
                                 table_.file(), fmt::join(names, ", "),
                                 printableText(fmt::format("{}", fmt::join(table_.names(), ", ")), 400))};
  }

  double largest(const std::string& name) const {
    const std::size_t column = table_.column(name);
    double largest = 0;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      largest = std::max(largest, std::abs(table_.number(row, column).value_or(0)));
    }
    return largest;
  }

  void addJoint(const Joint& joint, const NamedColumn& column) {
    JointColumn& entry = map_.joints[joint.name];
    entry.column = column.name;
    entry.unit = column.unit;
    used_.insert(column.name);
  }

  /// All angles have one unit where their names have none: one that exceeds a turn decides for all.
  void guessJointUnits() {
    bool areDegrees = false;
    for (const auto& [name, joint] : map_.joints) {
      areDegrees |= joint.unit.empty() && !isPrismatic(name) && largest(joint.column) > largestTurn;
    }
    for (auto& [name, joint] : map_.joints) {
      if (!joint.unit.empty()) {
        continue;
      }
      if (isPrismatic(name)) {
        joint.unit = largest(joint.column) > largestReach ? "mm" : "m";
      } else {
        joint.unit = areDegrees ? "deg" : "rad";
      }
    }
  }

  bool isPrismatic(const std::string& joint) const { return robot_.joints[*robot_.jointIndex(joint)].isPrismatic; }

  void guessNamedJoints() {
    for (const Joint& joint : robot_.joints) {
      const std::string name = joined(wordsOf(joint.name));
      for (const NamedColumn& column : columns_) {
        const bool isJoint = joined(column.words) == name || joined(wordsOf(column.name)) == name;
        if (isJoint && !map_.joints.contains(joint.name)) {
          addJoint(joint, column);
        }
      }
    }
    guessJointUnits();
  }

  void guessNumberedJoints() {
    std::map<int, const NamedColumn*> numbered;
    for (const NamedColumn& column : columns_) {
      if (const std::optional<int> number = jointNumber(column)) {
        numbered.emplace(*number, &column);
      }
    }
    auto next = numbered.begin();
    for (std::size_t i = 0; i < robot_.joints.size() && next != numbered.end(); ++i) {
      if (robot_.joints[i].motor == i) {
        addJoint(robot_.joints[i], *next->second);
        ++next;
      }
    }
    guessJointUnits();
  }

  /// The free column whose words are `stem` with `last` appended to the last word, or after it.
  const NamedColumn* find(const std::string& stem, const std::string& last) const {
    for (const NamedColumn& column : columns_) {
      const std::string name = joined(column.words);
      if (!used_.contains(column.name) && (name == stem + last || name == stem + "_" + last)) {
        return &column;
      }
    }
    return nullptr;
  }

  const NamedColumn* findAny(const std::string& stem, const std::vector<std::string>& lasts) const {
    for (const std::string& last : lasts) {
      if (const NamedColumn* column = find(stem, last)) {
        return column;
      }
    }
    return nullptr;
  }

  /// Whether columns "<stem>x", .. are no position: turns, forces, speeds. "tx" and "mx", unlike a marker's "m_x", are
  /// torques beside a force "fx". `name`: of the first column, in words.
  bool isNoPosition(const std::string& stem, const std::string& name) const {
    static const std::set<std::string> usual{"r",      "rot",    "rotation", "rotvec", "rvec",        "aa",
                                             "axis",   "euler",  "rpy",      "f",      "force",       "torque",
                                             "moment", "wrench", "v",        "vel",    "velocity",    "w",
                                             "omega",  "gyro",   "acc",      "accel",  "acceleration"};
    const std::string last = stem.substr(stem.rfind('_') + 1), before = stem.substr(0, stem.size() - last.size());
    const bool mayBeTorque = last == "t" || (last == "m" && name == stem + "x");
    return usual.contains(last) || (mayBeTorque && find(before + "f", "x") != nullptr);
  }

  /// The three columns of a position that are numbered from 0 or 1 in a pose such as "actual_TCP_pose_0" to "_5".
  void guessNumberedPosition() {
    static const std::set<std::string> usual{"pose", "position", "xyz", "tcp"};
    for (const NamedColumn& first : columns_) {
      if (used_.contains(first.name) || first.words.size() < 2 ||
          !usual.contains(first.words[first.words.size() - 2]) ||
          (first.words.back() != "0" && first.words.back() != "1")) {
        continue;
      }
      std::vector<std::string> words{first.words.begin(), first.words.end() - 1};
      const std::string stem = joined(words);
      const int number = std::stoi(first.words.back());
      const NamedColumn *y = find(stem, std::to_string(number + 1)), *z = find(stem, std::to_string(number + 2));
      if (y != nullptr && z != nullptr) {
        words.erase(words.begin(), words.begin() + (words.size() > 1 && measuredWords.contains(words.front()) ? 1 : 0));
        addPosition(joined(words), {&first, y, z});
        return;
      }
    }
  }

  /// Points and frames: stems of columns that end with x.
  void guessMeasuredPositions() {
    for (const NamedColumn& x : columns_) {
      const std::string name = joined(x.words);
      const bool isQuaternion = name == "qx" || name.ends_with("_qx") || name.ends_with("quat_x");
      if (used_.contains(x.name) || !name.ends_with("x") || isQuaternion) {
        continue;
      }
      std::string stem = name.substr(0, name.size() - 1);
      if (stem.ends_with("_")) {
        stem.pop_back();
      }
      const NamedColumn *y = find(stem, "y"), *z = find(stem, "z");
      if (y != nullptr && z != nullptr && !isNoPosition(stem, name)) {
        addPosition(stem, {&x, y, z});
      }
    }
  }

  void addPosition(const std::string& stem, const std::array<const NamedColumn*, 3>& xyz) {
    std::array<std::string, 3> names;
    double most = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      names[i] = xyz[i]->name;
      used_.insert(names[i]);
      most = std::max(most, largest(names[i]));
    }
    const std::string unit = metresPer(xyz[0]->unit) ? xyz[0]->unit : most > largestReach ? "mm" : "m";
    std::array<std::string, 4> quaternion;
    constexpr std::array<const char*, 4> parts{"w", "x", "y", "z"};
    bool isFrame = true;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const NamedColumn* part = findAny(stem, {std::string{"q"} + parts[i], std::string{"quat_"} + parts[i]});
      isFrame &= part != nullptr;
      quaternion[i] = part != nullptr ? part->name : "";
    }
    if (isFrame) {
      used_.insert(quaternion.begin(), quaternion.end());
      map_.frames.push_back({stem.empty() ? "tool" : stem, "tracker", "", names, unit, quaternion});
    } else {
      map_.points.push_back({stem.empty() ? "marker" : stem, "tracker", "", names, unit});
    }
  }

  std::optional<std::string> take(const std::set<std::string>& usual) {
    for (const NamedColumn& column : columns_) {
      if (!used_.contains(column.name) && usual.contains(joined(column.words))) {
        used_.insert(column.name);
        return column.name;
      }
    }
    return std::nullopt;
  }

  /// The first free column that names pictures, whatever it is called.
  std::optional<std::string> takePictures() {
    for (const NamedColumn& column : columns_) {
      if (!used_.contains(column.name) && namesPictures(column.name)) {
        used_.insert(column.name);
        return column.name;
      }
    }
    return std::nullopt;
  }

  /// Whether all cells but empty ones, and at least one, are names of picture files.
  bool namesPictures(const std::string& name) const {
    if (!table_.isUnique(name)) {
      return false;
    }
    const std::size_t column = table_.column(name);
    std::size_t pictures = 0;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      const std::string& cell = table_.text(row, column);
      if (!cell.empty() && !isPictureName(cell)) {
        return false;
      }
      pictures += cell.empty() ? 0 : 1;
    }
    return pictures > 0;
  }

  void guessOthers() {
    map_.image =
        take({"image", "img", "picture", "file", "filename", "file_name", "image_file", "image_name", "frame"});
    if (!map_.image) {
      map_.image = takePictures();
    }
    map_.time = take({"t", "time", "timestamp", "stamp", "seconds"});
    if (map_.time) {
      const std::string unit = nameColumn(*map_.time).unit;
      map_.timeUnit = secondsPer(unit) ? unit : timeUnitOf(largest(*map_.time));
    }
    map_.pose = take({"pose", "pose_id", "pose_name", "configuration", "config"});
    map_.repeat = take({"repeat", "repetition", "sample", "trial"});
    for (const auto& [joint, entry] : map_.joints) {
      for (const std::string& of : {joined(wordsOf(joint)), joined(nameColumn(entry.column).words)}) {
        const auto column = take({"temperature_" + of, of + "_temperature", "temp_" + of, of + "_temp"});
        if (column && !map_.temperature.contains(joint)) {
          map_.temperature[joint] = *column;
        }
      }
    }
  }

  const CsvTable& table_;
  const Robot& robot_;
  std::vector<NamedColumn> columns_;
  std::set<std::string> used_;
  ColumnMap map_;
};

} // namespace

ColumnGuess guessColumns(const CsvTable& table, const Robot& robot) {
  return Guesser{table, robot}.run();
}

} // namespace naocal
