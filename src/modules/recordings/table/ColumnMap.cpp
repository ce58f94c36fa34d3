#include "recordings/table/ColumnMap.hpp"

#include "io/InputError.hpp"
#include "io/JsonReader.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

constexpr Range anyFactor{-1e9, 1e9, ""};

void requireKnownKeys(const JsonCursor& object, const std::vector<std::string>& known) {
  for (const auto& [key, value] : object.members()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      value.refuse(fmt::format("one of the keys {}", fmt::join(known, ", ")), "the key " + printableText(key, 80));
    }
  }
}

std::string textOr(const JsonCursor& object, const std::string& key, const std::string& otherwise) {
  const auto value = object.find(key);
  return value ? value->text() : otherwise;
}

JointColumn readJoint(const JsonCursor& entry, const Joint& joint) {
  JointColumn result;
  result.unit = joint.isPrismatic ? "m" : "rad";
  if (entry.value().is_string()) {
    result.column = entry.text();
    return result;
  }
  requireKnownKeys(entry, {"column", "unit", "factor", "sign"});
  result.column = entry.at("column").text();
  if (const auto unit = entry.find("unit")) {
    result.unit = unit->text();
    const bool isLength = metresPer(result.unit).has_value(), isAngle = result.unit == "rad" || result.unit == "deg";
    if (joint.isPrismatic && !isLength) {
      unit->refuse("m, cm or mm, the units of a prismatic joint");
    }
    if (!joint.isPrismatic && !isAngle) {
      unit->refuse("rad or deg, the units of a joint that turns");
    }
  }
  if (const auto factor = entry.find("factor")) {
    result.factor = factor->number(anyFactor);
    if (result.factor == 0) {
      factor->refuse("a factor other than 0");
    }
  }
  if (const auto sign = entry.find("sign")) {
    result.sign = sign->integer(-1, 1);
    if (result.sign == 0) {
      sign->refuse("1 or -1");
    }
  }
  return result;
}

template <std::size_t count> std::array<std::string, count> readColumns(const JsonCursor& list, std::string_view what) {
  const std::vector<std::string> names = list.texts();
  if (names.size() != count) {
    list.refuse(fmt::format("{} columns: {}", count, what), std::to_string(names.size()));
  }
  std::array<std::string, count> result;
  std::copy(names.begin(), names.end(), result.begin());
  return result;
}

std::string readLink(const JsonCursor& entry, const Robot& robot) {
  const auto link = entry.find("link");
  if (!link) {
    return "";
  }
  if (!robot.linkIndex(link->text())) {
    link->refuse("a link of the URDF");
  }
  return link->text();
}

std::string readLengthUnit(const JsonCursor& entry) {
  const auto unit = entry.find("unit");
  if (!unit) {
    return "m";
  }
  if (!metresPer(unit->text())) {
    unit->refuse("m, cm or mm");
  }
  return unit->text();
}

PointColumns readPoint(const JsonCursor& entry, const Robot& robot) {
  requireKnownKeys(entry, {"marker", "tracker", "link", "columns", "unit"});
  return {entry.at("marker").text(), textOr(entry, "tracker", "tracker"), readLink(entry, robot),
          readColumns<3>(entry.at("columns"), "x, y, z"), readLengthUnit(entry)};
}

FrameColumns readFrame(const JsonCursor& entry, const Robot& robot) {
  requireKnownKeys(entry, {"frame", "tracker", "link", "columns", "unit", "quaternion"});
  return {entry.at("frame").text(), textOr(entry, "tracker", "tracker"),
          readLink(entry, robot),   readColumns<3>(entry.at("columns"), "x, y, z"),
          readLengthUnit(entry),    readColumns<4>(entry.at("quaternion"), "w, x, y, z")};
}

std::optional<std::string> findText(const JsonCursor& object, const std::string& key) {
  const auto value = object.find(key);
  return value ? std::optional{value->text()} : std::nullopt;
}

void readTime(const JsonCursor& document, ColumnMap& map) {
  const auto time = document.find("time");
  if (!time) {
    return;
  }
  if (time->value().is_string()) {
    map.time = time->text();
    return;
  }
  requireKnownKeys(*time, {"column", "unit"});
  map.time = time->at("column").text();
  if (const auto unit = time->find("unit")) {
    map.timeUnit = unit->text();
    if (!secondsPer(map.timeUnit)) {
      unit->refuse("s, ms, us or ns");
    }
  }
}

} // namespace

std::optional<double> metresPer(const std::string& unit) {
  static const std::map<std::string, double> factors{{"m", 1}, {"cm", 0.01}, {"mm", 0.001}};
  const auto found = factors.find(unit);
  return found == factors.end() ? std::nullopt : std::optional{found->second};
}

std::optional<double> secondsPer(const std::string& unit) {
  static const std::map<std::string, double> factors{{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}};
  const auto found = factors.find(unit);
  return found == factors.end() ? std::nullopt : std::optional{found->second};
}

ColumnMap parseColumnMap(const nlohmann::json& json, const std::string& file, const Robot& robot) {
  const JsonCursor document{json, file};
  requireKnownKeys(document, {"joints", "points", "frames", "image", "time", "pose", "repeat", "temperature"});
  ColumnMap map;
  for (const auto& [name, entry] : document.at("joints").members()) {
    const std::optional<std::size_t> joint = robot.jointIndex(name);
    if (!joint) {
      std::vector<std::string> names;
      for (const Joint& each : robot.joints) {
        names.push_back(each.name);
      }
      entry.refuse(fmt::format("a joint of the URDF: {}", fmt::join(closestNames(name, names, 8), ", ")),
                   printableText(name, 80));
    }
    map.joints[name] = readJoint(entry, robot.joints[*joint]);
  }
  if (const auto points = document.find("points")) {
    for (const JsonCursor& entry : points->elements()) {
      map.points.push_back(readPoint(entry, robot));
    }
  }
  if (const auto frames = document.find("frames")) {
    for (const JsonCursor& entry : frames->elements()) {
      map.frames.push_back(readFrame(entry, robot));
    }
  }
  map.image = findText(document, "image");
  readTime(document, map);
  map.pose = findText(document, "pose");
  map.repeat = findText(document, "repeat");
  if (const auto temperature = document.find("temperature")) {
    for (const auto& [name, column] : temperature->members()) {
      if (!map.joints.contains(name)) {
        column.refuse("a joint that has a column", printableText(name, 80));
      }
      map.temperature[name] = column.text();
    }
  }
  return map;
}

nlohmann::ordered_json columnMapJson(const ColumnMap& map) {
  nlohmann::ordered_json json{{"joints", nlohmann::ordered_json::object()}};
  for (const auto& [name, joint] : map.joints) {
    nlohmann::ordered_json& entry = json["joints"][name] = {{"column", joint.column}, {"unit", joint.unit}};
    if (joint.factor != 1) {
      entry["factor"] = joint.factor;
    }
    if (joint.sign != 1) {
      entry["sign"] = joint.sign;
    }
  }
  const auto addLink = [](nlohmann::ordered_json& entry, const std::string& link) {
    if (!link.empty()) {
      entry["link"] = link;
    }
  };
  for (const PointColumns& point : map.points) {
    nlohmann::ordered_json entry{{"marker", point.marker}, {"tracker", point.tracker}};
    addLink(entry, point.link);
    entry["columns"] = point.columns;
    entry["unit"] = point.unit;
    json["points"].push_back(std::move(entry));
  }
  for (const FrameColumns& frame : map.frames) {
    nlohmann::ordered_json entry{{"frame", frame.frame}, {"tracker", frame.tracker}};
    addLink(entry, frame.link);
    entry["columns"] = frame.columns;
    entry["unit"] = frame.unit;
    entry["quaternion"] = frame.quaternion;
    json["frames"].push_back(std::move(entry));
  }
  for (const auto& [key, column] : {std::pair{"image", map.image}, {"pose", map.pose}, {"repeat", map.repeat}}) {
    if (column) {
      json[key] = *column;
    }
  }
  if (map.time) {
    json["time"] = {{"column", *map.time}, {"unit", map.timeUnit}};
  }
  for (const auto& [joint, column] : map.temperature) {
    json["temperature"][joint] = column;
  }
  return json;
}

} // namespace naocal
