#include "model/DrawingReader.hpp"

#include "geometry/Angles.hpp"
#include "model/DrawingPlaces.hpp"

namespace naocal {

namespace {

void readLengths(const JsonPlace& drawing, Robot& robot) {
  for (const auto& [name, length] : section(drawing, "lengthsMillimetres")) {
    robot.lengths.push_back({name, length.number({0, millimetreRange.highest, millimetreRange.unit}) / 1000});
  }
}

/// How far the link lies from its parent: a constant part, and lengths along directions.
void readOrigin(const JsonPlace& place, const Robot& robot, Link& link) {
  if (const auto origin = place.find("originMillimetres")) {
    link.constant = metres3(*origin);
  }
  if (const auto along = place.find("alongLengths")) {
    for (const auto& [name, direction] : entries(*along)) {
      const auto length = robot.lengthIndex(name);
      if (!length) {
        along->refuse("only names of lengthsMillimetres", '"' + name + '"');
      }
      link.stretches.push_back({*length, vector3(direction, directionRange)});
    }
  }
}

void readLink(const JsonPlace& place, Robot& robot) {
  Link link;
  link.name = place.at("name").text();
  if (robot.linkIndex(link.name)) {
    place.at("name").refuse("a name that no link before has");
  }
  if (robot.links.empty()) {
    allowOnly(place, {"name"}); // the root has no parent to lie in
  } else {
    allowOnly(place, {"name", "parent", "joint", "originMillimetres", "alongLengths"});
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

void readTree(const JsonPlace& drawing, Robot& robot) {
  const JsonPlace tree = drawing.at("tree");
  allowOnly(tree, {"links"});
  for (const JsonPlace& link : tree.at("links").elements()) {
    readLink(link, robot);
  }
  if (robot.links.empty()) {
    tree.at("links").refuse("at least one link");
  }
}

void readMasses(const JsonPlace& drawing, Robot& robot) {
  for (const auto& [name, place] : section(drawing, "masses")) {
    allowOnly(place, {"kilograms", "centreMillimetres"});
    const auto index = robot.linkIndex(name);
    if (!index) {
      place.refuse("only links of the tree", '"' + name + '"');
    }
    Link& link = robot.links[*index];
    link.mass = place.at("kilograms").number({0, 1000, "kilograms"});
    link.centreOfMass = metres3(place.at("centreMillimetres"));
  }
}

void readCameras(const JsonPlace& drawing, Robot& robot) {
  for (const auto& [name, place] : section(drawing, "cameras")) {
    allowOnly(place, {"link", "originMillimetres", "pitchDegrees"});
    robot.cameras.push_back({.name = name,
                             .link = linkAt(place.at("link"), robot),
                             .translation = metres3(place.at("originMillimetres")),
                             .pitch = radians(place.at("pitchDegrees").number(degreeRange))});
  }
}

void readHull(const JsonPlace& drawing, Robot& robot) {
  const auto hull = drawing.find("hull");
  if (!hull) {
    return;
  }
  allowOnly(*hull, {"capsules"});
  for (const JsonPlace& place : hull->at("capsules").elements()) {
    allowOnly(place, {"link", "fromMillimetres", "toMillimetres", "radiusMillimetres"});
    robot.hull.push_back({.link = linkAt(place.at("link"), robot),
                          .from = metres3(place.at("fromMillimetres")),
                          .to = metres3(place.at("toMillimetres")),
                          .radius = place.at("radiusMillimetres").number({0, 1000, "millimetres"}) / 1000});
  }
}

} // namespace

Robot readDrawing(const JsonPlace& drawing) {
  allowOnly(drawing, {"format", "version", "base", "model", "lengthsMillimetres", "tree", "joints", "masses", "cameras",
                      "soles", "hull"});
  Robot robot;
  robot.model = drawing.at("model").text();
  readLengths(drawing, robot); // each section may name things of the sections before it
  readTree(drawing, robot);
  readJoints(drawing, robot);
  readMasses(drawing, robot);
  readCameras(drawing, robot);
  readSoles(drawing, robot);
  readHull(drawing, robot);
  return robot;
}

} // namespace naocal
