#include "recordings/table/ColumnMeaning.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace naocal {

namespace {

const std::vector<std::string> angleUnits{"rad", "deg"}, lengthUnits{"m", "cm", "mm"}, timeUnits{"s", "ms", "us", "ns"};
constexpr std::array<const char*, 3> axes{"x", "y", "z"};
constexpr std::array<const char*, 4> quaternionParts{"w", "x", "y", "z"};

const std::vector<std::string>& unitsOf(const Joint& joint) {
  return joint.isPrismatic ? lengthUnits : angleUnits;
}

std::string factorWords(const JointColumn& column) {
  const double factor = column.sign * column.factor;
  return factor == 1 ? "" : fmt::format(", times {}", factor);
}

void addJoints(const ColumnMap& map, const Robot& robot, std::vector<ColumnMeaning>& all) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    const auto found = map.joints.find(joint.name);
    const bool isMapped = found != map.joints.end();
    if (joint.motor != i && !isMapped) {
      continue; // it mimics another
    }
    all.push_back({"joint:" + joint.name,
                   fmt::format("{} of joint {}{}", joint.isPrismatic ? "position" : "angle", joint.name,
                               isMapped ? factorWords(found->second) : ""),
                   isMapped ? found->second.column : "", unitsOf(joint), isMapped ? found->second.unit : ""});
  }
}

void addPositions(const ColumnMap& map, std::vector<ColumnMeaning>& all) {
  const auto add = [&](const std::string& id, const std::string& of, const std::array<std::string, 3>& columns,
                       const std::string& unit) {
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      all.push_back({fmt::format("{}:{}", id, axes[axis]), fmt::format("{} of {}", axes[axis], of), columns[axis],
                     lengthUnits, unit});
    }
  };
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    const PointColumns& point = map.points[i];
    add(fmt::format("point:{}", i), fmt::format("marker {}, measured by {}", point.marker, point.tracker),
        point.columns, point.unit);
  }
  for (std::size_t i = 0; i < map.frames.size(); ++i) {
    const FrameColumns& frame = map.frames[i];
    const std::string id = fmt::format("frame:{}", i),
                      of = fmt::format("frame {}, measured by {}", frame.frame, frame.tracker);
    add(id, of, frame.columns, frame.unit);
    for (std::size_t part = 0; part < quaternionParts.size(); ++part) {
      all.push_back({fmt::format("{}:q{}", id, quaternionParts[part]),
                     fmt::format("{} of the quaternion of {}", quaternionParts[part], of),
                     frame.quaternion[part],
                     {},
                     ""});
    }
  }
}

void addTemperatures(const ColumnMap& map, const Robot& robot, std::vector<ColumnMeaning>& all) {
  for (const Joint& joint : robot.joints) {
    if (map.joints.contains(joint.name)) {
      const auto found = map.temperature.find(joint.name);
      all.push_back({"temperature:" + joint.name,
                     fmt::format("temperature of joint {} [°C]", joint.name),
                     found == map.temperature.end() ? "" : found->second,
                     {},
                     ""});
    }
  }
}

/// Removes a column from wherever it is in a map.
void releaseColumn(ColumnMap& map, const std::string& column) {
  const auto holds = [&](const auto& columns) {
    return std::find(columns.begin(), columns.end(), column) != columns.end();
  };
  for (auto joint = map.joints.begin(); joint != map.joints.end();) {
    if (joint->second.column == column) {
      map.temperature.erase(joint->first);
      joint = map.joints.erase(joint);
    } else {
      ++joint;
    }
  }
  std::erase_if(map.points, [&](const PointColumns& point) { return holds(point.columns); });
  std::erase_if(map.frames, [&](const FrameColumns& frame) { return holds(frame.columns) || holds(frame.quaternion); });
  for (std::optional<std::string>* single : {&map.image, &map.time, &map.pose, &map.repeat}) {
    if (*single == column) {
      single->reset();
    }
  }
  std::erase_if(map.temperature, [&](const auto& entry) { return entry.second == column; });
}

/// The unit of the joints of this kind that have a column; otherwise that of a column map without units.
std::string usualUnit(const ColumnMap& map, const Robot& robot, const Joint& joint) {
  for (const auto& [name, column] : map.joints) {
    if (robot.joints[*robot.jointIndex(name)].isPrismatic == joint.isPrismatic) {
      return column.unit;
    }
  }
  return unitsOf(joint).front();
}

/// Changes the unit of a meaning that has a column.
void setUnit(ColumnMap& map, const std::string& id, const std::string& unit) {
  const std::string kind = id.substr(0, id.find(':'));
  if (kind == "joint") {
    map.joints.at(id.substr(kind.size() + 1)).unit = unit;
  } else if (kind == "point") {
    map.points.at(std::stoul(id.substr(kind.size() + 1))).unit = unit;
  } else if (kind == "frame") {
    map.frames.at(std::stoul(id.substr(kind.size() + 1))).unit = unit;
  } else {
    map.timeUnit = unit;
  }
}

void setColumn(ColumnMap& map, const Robot& robot, const std::string& column, const std::string& id) {
  const std::string kind = id.substr(0, id.find(':')), place = id.substr(std::min(id.size(), kind.size() + 1));
  if (kind == "joint") {
    const auto before = map.joints.find(place);
    JointColumn joint;
    if (before != map.joints.end()) {
      joint = before->second;
    } else {
      joint.unit = usualUnit(map, robot, robot.joints[*robot.jointIndex(place)]);
    }
    joint.column = column;
    map.joints[place] = joint;
  } else if (kind == "temperature") {
    map.temperature[place] = column;
  } else {
    (kind == "image" ? map.image : kind == "time" ? map.time : kind == "pose" ? map.pose : map.repeat) = column;
  }
}

/// Throws InputError if a map has no such meaning.
ColumnMeaning findMeaning(const ColumnMap& map, const Robot& robot, const std::string& column, const std::string& id) {
  std::vector<std::string> ids;
  for (ColumnMeaning& meaning : columnMeanings(map, robot)) {
    if (meaning.id == id) {
      return meaning;
    }
    ids.push_back(std::move(meaning.id));
  }
  throw InputError{fmt::format("column \"{}\": expected a meaning such as {}, found \"{}\"", printableText(column, 80),
                               fmt::join(closestNames(id, ids), ", "), printableText(id, 80))};
}

} // namespace

std::vector<ColumnMeaning> columnMeanings(const ColumnMap& map, const Robot& robot) {
  std::vector<ColumnMeaning> all;
  addJoints(map, robot, all);
  addPositions(map, all);
  all.push_back({"image", "file name of the picture", map.image.value_or(""), {}, ""});
  all.push_back({"time", "time", map.time.value_or(""), timeUnits, map.time ? map.timeUnit : ""});
  all.push_back({"pose", "name of the pose", map.pose.value_or(""), {}, ""});
  all.push_back({"repeat", "number of the repeat of a pose", map.repeat.value_or(""), {}, ""});
  addTemperatures(map, robot, all);
  return all;
}

void assignColumn(ColumnMap& map, const Robot& robot, const std::string& column, const std::string& id,
                  const std::string& unit) {
  if (id.empty()) {
    return releaseColumn(map, column);
  }
  const ColumnMeaning meaning = findMeaning(map, robot, column, id);
  if (!unit.empty() && std::find(meaning.units.begin(), meaning.units.end(), unit) == meaning.units.end()) {
    throw InputError{fmt::format("column \"{}\", {}: expected {}, found the unit \"{}\"", printableText(column, 80),
                                 meaning.words,
                                 meaning.units.empty() ? "no unit" : fmt::format("{}", fmt::join(meaning.units, ", ")),
                                 printableText(unit, 80))};
  }
  if (meaning.column != column) {
    if (id.starts_with("point:") || id.starts_with("frame:")) {
      throw InputError{fmt::format("column \"{}\", {}: expected all columns of it together, found one; write them into "
                                   "the column map",
                                   printableText(column, 80), meaning.words)};
    }
    ColumnMap changed = map;
    releaseColumn(changed, column);
    findMeaning(changed, robot, column, id); // a joint that loses its column has no temperature
    setColumn(changed, robot, column, id);
    map = std::move(changed);
  }
  if (!unit.empty()) {
    setUnit(map, id, unit);
  }
}

} // namespace naocal
