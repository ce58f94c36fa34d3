#include "model/DrawingPlaces.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace naocal {

std::vector<std::pair<std::string, JsonPlace>> entries(const JsonPlace& place) {
  auto members = place.members();
  std::erase_if(members, [](const auto& member) { return member.first == "source" || member.first == "note"; });
  return members;
}

std::vector<std::pair<std::string, JsonPlace>> section(const JsonPlace& drawing, const std::string& key) {
  const auto place = drawing.find(key);
  return place ? entries(*place) : std::vector<std::pair<std::string, JsonPlace>>{};
}

void allowOnly(const JsonPlace& place, const std::vector<std::string_view>& keys) {
  for (const auto& [key, value] : entries(place)) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      place.refuse(fmt::format("no keys but {}, source, note", fmt::join(keys, ", ")), '"' + key + '"');
    }
  }
}

Eigen::Vector3d vector3(const JsonPlace& place, const Range& range) {
  const auto xyz = place.numbers(3, range, "x, y, z");
  return {xyz[0], xyz[1], xyz[2]};
}

Eigen::Vector3d metres3(const JsonPlace& millimetres) {
  return vector3(millimetres, millimetreRange) / 1000;
}

Eigen::Vector2d metres2(const JsonPlace& millimetres) {
  const auto xy = millimetres.numbers(2, millimetreRange, "x, y");
  return {xy[0] / 1000, xy[1] / 1000};
}

std::size_t linkAt(const JsonPlace& place, const Robot& robot) {
  const auto link = robot.linkIndex(place.text());
  if (!link) {
    place.refuse("the name of a link of the tree");
  }
  return *link;
}

std::size_t jointAt(const JsonPlace& place, const Robot& robot) {
  const auto joint = robot.jointIndex(place.text());
  if (!joint) {
    place.refuse("the name of a joint of the tree");
  }
  return *joint;
}

} // namespace naocal
