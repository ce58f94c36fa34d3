#include "model/DrawingPlaces.hpp"

#include <algorithm>

namespace naocal {

namespace {

using Outline = std::vector<Eigen::Vector2d>;

/// Strictly convex, counter-clockwise: every corner lies to the left of every other side.
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

Outline ownOutline(const JsonPlace& place) {
  Outline outline;
  for (const JsonPlace& point : place.elements()) {
    outline.push_back(metres2(point));
  }
  if (!isConvex(outline)) {
    place.refuse("a strictly convex outline, counter-clockwise");
  }
  return outline;
}

/// The outline given here, or the mirror image of another sole's.
Outline outline(const JsonPlace& place, const JsonPlace& soles) {
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
  std::reverse(outline.begin(), outline.end()); // a mirror image runs the other way round
  for (Eigen::Vector2d& point : outline) {
    point.y() = -point.y();
  }
  return outline;
}

} // namespace

void readSoles(const JsonPlace& drawing, Robot& robot) {
  for (const auto& [name, place] : section(drawing, "soles")) {
    allowOnly(place, {"link", "outlineMillimetres", "outlineMirroredFrom", "forceSensorsMillimetres"});
    Sole sole;
    sole.name = name;
    sole.link = linkAt(place.at("link"), robot);
    sole.outline = outline(place, drawing.at("soles"));
    if (const auto sensors = place.find("forceSensorsMillimetres")) {
      allowOnly(*sensors, {"FL", "FR", "RL", "RR"});
      for (const char* sensor : {"FL", "FR", "RL", "RR"}) {
        sole.forceSensors.push_back(metres2(sensors->at(sensor)));
      }
    }
    robot.soles.push_back(std::move(sole));
  }
}

} // namespace naocal
