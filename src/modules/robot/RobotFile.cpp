#include "robot/Robot.hpp"

#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "math/Angles.hpp"
#include "math/RigidTransform.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace naocal {

// Helpers of the description's reader.

inline constexpr Range millimetreRange{-10000, 10000, "millimetres"};
inline constexpr Range degreeRange{-360, 360, "degrees"};
inline constexpr Range directionRange{-1, 1, ""};

/// Entries of an object, except "source" and "note", which are allowed everywhere as documentation.
std::vector<std::pair<std::string, JsonCursor>> entries(const JsonCursor& place);

/// Entries of a section; empty if absent.
std::vector<std::pair<std::string, JsonCursor>> section(const JsonCursor& drawing, const std::string& key);

/// Refuses unknown keys: a misspelt optional key would silently change the robot.
void requireKnownKeys(const JsonCursor& place, const std::vector<std::string_view>& keys);

Eigen::Vector3d readVector3(const JsonCursor& place, const Range& range);
Eigen::Vector3d readMetres3(const JsonCursor& millimetres);
Eigen::Vector2d readMetres2(const JsonCursor& millimetres);

/// Index of the link or joint named at this place.
std::size_t readLink(const JsonCursor& place, const Robot& robot);
std::size_t readJoint(const JsonCursor& place, const Robot& robot);

/// Reads the sections "joints" and "soles". Requires the robot's tree.
void readJoints(const JsonCursor& drawing, Robot& robot);
void readSoles(const JsonCursor& drawing, Robot& robot);

/// Builds the robot from a complete description (base already merged). Throws InputError at the first place that
/// deviates from the format of home/configuration/drawings/NaoV5.json.
Robot parseRobot(const JsonCursor& drawing);

namespace {

AngleRange angleRange(const JsonCursor& place, double lowerDegrees, double upperDegrees) {
  if (lowerDegrees > upperDegrees) {
    place.refuse("a lower limit not above the upper one");
  }
  return {radians(lowerDegrees), radians(upperDegrees)};
}

CoupledLimits coupledLimits(const JsonCursor& place, const Robot& robot, std::size_t joint) {
  requireKnownKeys(place, {"on", "rowsDegrees"});
  CoupledLimits coupled;
  coupled.onJoint = readJoint(place.at("on"), robot);
  if (coupled.onJoint == joint) {
    place.at("on").refuse("another joint");
  }
  for (const JsonCursor& row : place.at("rowsDegrees").elements()) {
    const auto numbers = row.numbers(3, degreeRange, "angle, lower, upper");
    if (!coupled.angles.empty() && radians(numbers[0]) <= coupled.angles.back()) {
      row.refuse("an angle above that of the row before");
    }
    coupled.angles.push_back(radians(numbers[0]));
    coupled.ranges.push_back(angleRange(row, numbers[1], numbers[2]));
  }
  if (coupled.angles.empty()) {
    place.at("rowsDegrees").refuse("at least one row");
  }
  return coupled;
}

void readJointEntry(const JsonCursor& place, Robot& robot, std::size_t index) {
  requireKnownKeys(
      place, {"axis", "limitsDegrees", "maxSpeedDegreesPerSecond", "restingDegrees", "drivenBy", "coupledLimits"});
  Joint& joint = robot.joints[index];
  joint.axis = readVector3(place.at("axis"), directionRange);
  if (joint.axis.norm() == 0) {
    place.at("axis").refuse("a direction", "[0, 0, 0]");
  }
  joint.axis.normalize();
  const JsonCursor limits = place.at("limitsDegrees");
  const auto bounds = limits.numbers(2, degreeRange, "lower, upper");
  joint.limits = angleRange(limits, bounds[0], bounds[1]);
  joint.maxSpeed = radians(place.at("maxSpeedDegreesPerSecond").number({0.1, 10000, "degrees per second"}));
  if (const auto resting = place.find("restingDegrees")) {
    joint.restAngle = radians(resting->number(degreeRange));
  }
  const auto motor = place.find("drivenBy");
  joint.motor = motor ? readJoint(*motor, robot) : index;
  if (const auto coupled = place.find("coupledLimits")) {
    joint.coupled = coupledLimits(*coupled, robot, index);
  }
}

} // namespace

void readJoints(const JsonCursor& drawing, Robot& robot) {
  for (const auto& [name, place] : section(drawing, "joints")) {
    if (!robot.jointIndex(name)) {
      place.refuse("only joints of the tree", '"' + name + '"');
    }
  }
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    readJointEntry(drawing.at("joints").at(robot.joints[joint].name), robot, joint);
  }
  for (const Joint& joint : robot.joints) {
    if (robot.joints[joint.motor].motor != joint.motor) {
      drawing.at("joints").at(joint.name).at("drivenBy").refuse("a joint with a motor of its own");
    }
  }
}

std::vector<std::pair<std::string, JsonCursor>> entries(const JsonCursor& place) {
  auto members = place.members();
  std::erase_if(members, [](const auto& member) { return member.first == "source" || member.first == "note"; });
  return members;
}

std::vector<std::pair<std::string, JsonCursor>> section(const JsonCursor& drawing, const std::string& key) {
  const auto place = drawing.find(key);
  return place ? entries(*place) : std::vector<std::pair<std::string, JsonCursor>>{};
}

void requireKnownKeys(const JsonCursor& place, const std::vector<std::string_view>& keys) {
  for (const auto& [key, value] : entries(place)) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      place.refuse(fmt::format("no keys but {}, source, note", fmt::join(keys, ", ")), '"' + key + '"');
    }
  }
}

Eigen::Vector3d readVector3(const JsonCursor& place, const Range& range) {
  const auto xyz = place.numbers(3, range, "x, y, z");
  return {xyz[0], xyz[1], xyz[2]};
}

Eigen::Vector3d readMetres3(const JsonCursor& millimetres) {
  return readVector3(millimetres, millimetreRange) / 1000;
}

Eigen::Vector2d readMetres2(const JsonCursor& millimetres) {
  const auto xy = millimetres.numbers(2, millimetreRange, "x, y");
  return {xy[0] / 1000, xy[1] / 1000};
}

std::size_t readLink(const JsonCursor& place, const Robot& robot) {
  const auto link = robot.linkIndex(place.text());
  if (!link) {
    place.refuse("the name of a link of the tree");
  }
  return *link;
}

std::size_t readJoint(const JsonCursor& place, const Robot& robot) {
  const auto joint = robot.jointIndex(place.text());
  if (!joint) {
    place.refuse("the name of a joint of the tree");
  }
  return *joint;
}

namespace {

void readLengths(const JsonCursor& drawing, Robot& robot) {
  for (const auto& [name, length] : section(drawing, "lengthsMillimetres")) {
    robot.lengths.push_back({name, length.number({0, millimetreRange.highest, millimetreRange.unit}) / 1000});
  }
}

/// Reads the link's origin in its parent: a constant part, and lengths along directions.
void readOrigin(const JsonCursor& place, const Robot& robot, Link& link) {
  if (const auto origin = place.find("originMillimetres")) {
    link.constant = readMetres3(*origin);
  }
  if (const auto along = place.find("alongLengths")) {
    for (const auto& [name, direction] : entries(*along)) {
      const auto length = robot.lengthIndex(name);
      if (!length) {
        along->refuse("only names of lengthsMillimetres", '"' + name + '"');
      }
      link.stretches.push_back({*length, readVector3(direction, directionRange)});
    }
  }
}

void readLinkEntry(const JsonCursor& place, Robot& robot) {
  Link link;
  link.name = place.at("name").text();
  if (robot.linkIndex(link.name)) {
    place.at("name").refuse("a name that no link before has");
  }
  if (robot.links.empty()) {
    requireKnownKeys(place, {"name"}); // the root has no parent
  } else {
    requireKnownKeys(place, {"name", "parent", "joint", "originMillimetres", "alongLengths"});
    link.parent = robot.linkIndex(place.at("parent").text());
    if (!link.parent) {
      place.at("parent").refuse("the name of a link before this one");
    }
    readOrigin(place, robot, link);
  }
  if (const auto name = place.find("joint")) {
    if (robot.jointIndex(name->text())) {
      name->refuse("a joint that moves no link before");
    }
    link.joint = robot.joints.size();
    Joint& joint = robot.joints.emplace_back();
    joint.name = name->text();
    joint.link = robot.links.size();
  }
  robot.links.push_back(std::move(link));
}

void readTree(const JsonCursor& drawing, Robot& robot) {
  const JsonCursor tree = drawing.at("tree");
  requireKnownKeys(tree, {"links"});
  for (const JsonCursor& link : tree.at("links").elements()) {
    readLinkEntry(link, robot);
  }
  if (robot.links.empty()) {
    tree.at("links").refuse("at least one link");
  }
}

void readMasses(const JsonCursor& drawing, Robot& robot) {
  for (const auto& [name, place] : section(drawing, "masses")) {
    requireKnownKeys(place, {"kilograms", "centreMillimetres"});
    const auto index = robot.linkIndex(name);
    if (!index) {
      place.refuse("only links of the tree", '"' + name + '"');
    }
    Link& link = robot.links[*index];
    link.mass = place.at("kilograms").number({0, 1000, "kilograms"});
    link.centreOfMass = readMetres3(place.at("centreMillimetres"));
  }
}

void readCameras(const JsonCursor& drawing, Robot& robot) {
  for (const auto& [name, place] : section(drawing, "cameras")) {
    requireKnownKeys(place, {"link", "originMillimetres", "pitchDegrees"});
    robot.cameras.push_back({.name = name,
                             .link = readLink(place.at("link"), robot),
                             .translation = readMetres3(place.at("originMillimetres")),
                             .rotation = rotationY(radians(place.at("pitchDegrees").number(degreeRange)))});
  }
}

void readHull(const JsonCursor& drawing, Robot& robot) {
  const auto hull = drawing.find("hull");
  if (!hull) {
    return;
  }
  requireKnownKeys(*hull, {"capsules"});
  for (const JsonCursor& place : hull->at("capsules").elements()) {
    requireKnownKeys(place, {"link", "fromMillimetres", "toMillimetres", "radiusMillimetres"});
    robot.collisionCapsules.push_back(
        {.link = readLink(place.at("link"), robot),
         .from = readMetres3(place.at("fromMillimetres")),
         .to = readMetres3(place.at("toMillimetres")),
         .radius = place.at("radiusMillimetres").number({0, 1000, "millimetres"}) / 1000});
  }
}

} // namespace

Robot parseRobot(const JsonCursor& drawing) {
  requireKnownKeys(drawing, {"format", "version", "base", "model", "lengthsMillimetres", "tree", "joints", "masses",
                             "cameras", "soles", "hull"});
  Robot robot;
  robot.model = drawing.at("model").text();
  readLengths(drawing, robot); // a section may refer to the sections before it
  readTree(drawing, robot);
  readJoints(drawing, robot);
  readMasses(drawing, robot);
  readCameras(drawing, robot);
  readSoles(drawing, robot);
  readHull(drawing, robot);
  return robot;
}

namespace {

using Outline = std::vector<Eigen::Vector2d>;

/// Strictly convex, counter-clockwise: every corner lies to the left of every side that it does not end.
bool isConvex(const Outline& outline) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t next = (i + 1) % outline.size();
    const Eigen::Vector2d side = outline[next] - outline[i];
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Eigen::Vector2d offset = outline[k] - outline[i];
      if (k != i && k != next && side.x() * offset.y() - side.y() * offset.x() <= 0) {
        return false;
      }
    }
  }
  return outline.size() >= 3;
}

Outline ownOutline(const JsonCursor& place) {
  Outline outline;
  for (const JsonCursor& point : place.elements()) {
    outline.push_back(readMetres2(point));
  }
  if (!isConvex(outline)) {
    place.refuse("a strictly convex outline, counter-clockwise");
  }
  return outline;
}

/// The outline given here, or the mirror image of another sole's.
Outline outline(const JsonCursor& place, const JsonCursor& soles) {
  const auto own = place.find("outlineMillimetres"), mirrored = place.find("outlineMirroredFrom");
  if (own && mirrored) {
    place.refuse("outlineMillimetres or outlineMirroredFrom", "both");
  }
  if (!mirrored) {
    return ownOutline(place.at("outlineMillimetres"));
  }
  const auto other = soles.find(mirrored->text());
  if (!other || !other->find("outlineMillimetres")) {
    mirrored->refuse("the name of a sole with outlineMillimetres");
  }
  Outline outline = ownOutline(other->at("outlineMillimetres"));
  std::reverse(outline.begin(), outline.end()); // mirroring reverses the orientation
  for (Eigen::Vector2d& point : outline) {
    point.y() = -point.y();
  }
  return outline;
}

} // namespace

void readSoles(const JsonCursor& drawing, Robot& robot) {
  for (const auto& [name, place] : section(drawing, "soles")) {
    requireKnownKeys(place, {"link", "outlineMillimetres", "outlineMirroredFrom", "forceSensorsMillimetres"});
    Sole sole;
    sole.name = name;
    sole.link = readLink(place.at("link"), robot);
    sole.outline = outline(place, drawing.at("soles"));
    if (const auto sensors = place.find("forceSensorsMillimetres")) {
      requireKnownKeys(*sensors, {"FL", "FR", "RL", "RR"});
      for (const char* sensor : {"FL", "FR", "RL", "RR"}) {
        sole.forceSensors.push_back(readMetres2(sensors->at(sensor)));
      }
    }
    robot.soles.push_back(std::move(sole));
  }
}

namespace {

/// Parses the file and checks its format and version.
nlohmann::json document(const std::filesystem::path& file) {
  nlohmann::json document = parseJson(readFile(file), file.string());
  const JsonCursor top{document, file.string()};
  requireFormat(top, "naocal-drawing");
  return document;
}

/// Descriptions in a folder by model: <model>.json, but Nao<model>.json for a NAO, whose models are short: "V6".
std::map<std::string, std::filesystem::path> models(const std::filesystem::path& drawings) {
  std::map<std::string, std::filesystem::path> files;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator{drawings, unreadable}) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".json") {
      files.emplace(name.starts_with("Nao") ? name.substr(3) : name, entry.path());
    }
  }
  return files;
}

std::string listNames(const std::map<std::string, std::filesystem::path>& files) {
  std::vector<std::string> names;
  for (const auto& [name, file] : files) {
    names.push_back(name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

} // namespace

Robot loadRobot(const std::filesystem::path& drawing) {
  const nlohmann::json own = document(drawing);
  const JsonCursor top{own, drawing.string()};
  const auto base = top.find("base");
  if (!base) {
    return parseRobot(top);
  }
  nlohmann::json merged = document(drawing.parent_path() / base->text());
  if (merged.contains("base")) {
    base->refuse("a drawing that has no base of its own");
  }
  merged.merge_patch(own);
  return parseRobot(JsonCursor{merged, fmt::format("{} (with its base {})", drawing.string(), base->text())});
}

Robot loadRobot(const std::filesystem::path& configuration, std::string_view model) {
  const auto drawings = configuration / "drawings";
  const std::map<std::string, std::filesystem::path> known = models(drawings);
  const auto drawing = known.find(std::string{model});
  if (drawing == known.end()) {
    throw InputError{
        known.empty()
            ? fmt::format("{}: expected drawings of robots, found none; set NAOCAL_CONFIGURATION to the "
                          "configuration's folder",
                          drawings.string())
            : fmt::format("{}: expected a drawing of one of the robots {{{}}}, found none of \"{}\"; name one "
                          "of them, or set NAOCAL_CONFIGURATION to the configuration's folder",
                          drawings.string(), listNames(known), printableText(model, 60))};
  }
  Robot robot = loadRobot(drawing->second);
  if (robot.model != model) {
    throw InputError{fmt::format("{}: model: expected \"{}\", as in the file's name, found \"{}\"; rename the file or "
                                 "correct the model",
                                 drawing->second.string(), model, printableText(robot.model, 60))};
  }
  return robot;
}

} // namespace naocal
