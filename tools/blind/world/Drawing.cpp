#include "world/Drawing.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace blind {

namespace {

using nlohmann::json;

Eigen::Vector3d vectorOf(const json& list, double unit) {
  return Eigen::Vector3d{list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()} * unit;
}

json mergedFile(const std::filesystem::path& file) {
  std::ifstream stream{file};
  if (!stream) {
    throw std::runtime_error{fmt::format("{}: expected a robot's drawing, found no readable file", file.string())};
  }
  json drawing = json::parse(stream);
  if (drawing.contains("base")) {
    json base = mergedFile(file.parent_path() / drawing.at("base").get<std::string>());
    base.merge_patch(drawing);
    return base;
  }
  return drawing;
}

/// A link during the traversal of the tree.
struct Link {
  int joint = -1; // last joint that moves it
  Eigen::Vector3d fixedPlace = Eigen::Vector3d::Zero();
  std::map<std::string, Eigen::Vector3d> alongLengths;
};

Link childOf(const Link& parent, const json& entry) {
  Link link = parent;
  if (entry.contains("originMillimetres")) {
    link.fixedPlace += vectorOf(entry.at("originMillimetres"), 1e-3);
  }
  if (entry.contains("alongLengths")) {
    for (const auto& [name, direction] : entry.at("alongLengths").items()) {
      link.alongLengths.try_emplace(name, Eigen::Vector3d::Zero()).first->second += vectorOf(direction, 1);
    }
  }
  return link;
}

Drawing::Joint jointOf(const json& entry, const Link& link, const std::string& name) {
  Drawing::Joint joint;
  joint.name = name;
  joint.parent = link.joint;
  joint.fixedPlace = link.fixedPlace;
  joint.alongLengths = link.alongLengths;
  joint.axis = vectorOf(entry.at("axis"), 1).normalized();
  joint.lower = entry.at("limitsDegrees").at(0).get<double>() * radiansPerDegree;
  joint.upper = entry.at("limitsDegrees").at(1).get<double>() * radiansPerDegree;
  joint.resting = entry.value("restingDegrees", 0.0) * radiansPerDegree;
  joint.drivenBy = entry.value("drivenBy", "");
  if (entry.contains("coupledLimits")) {
    joint.coupledTo = entry.at("coupledLimits").at("on").get<std::string>();
    for (const json& row : entry.at("coupledLimits").at("rowsDegrees")) {
      const Eigen::Vector3d angles = vectorOf(row, radiansPerDegree);
      joint.coupled.push_back({angles.x(), angles.y(), angles.z()});
    }
  }
  return joint;
}

void readSoles(const json& soles, const std::map<std::string, Link>& links, Drawing& drawing) {
  for (std::size_t side = 0; side < 2; ++side) {
    const json& entry = soles.at(side == 0 ? "left" : "right");
    const bool mirrored = entry.contains("outlineMirroredFrom");
    Drawing::Sole& sole = drawing.soles[side];
    sole.joint = links.at(entry.at("link").get<std::string>()).joint;
    for (const json& point : (mirrored ? soles.at("left") : entry).at("outlineMillimetres")) {
      sole.outline.emplace_back(1e-3 * point.at(0).get<double>(),
                                (mirrored ? -1e-3 : 1e-3) * point.at(1).get<double>());
    }
    if (mirrored) {
      std::reverse(sole.outline.begin(), sole.outline.end());
    }
  }
}

} // namespace

int Drawing::joint(const std::string& name) const {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].name == name) {
      return static_cast<int>(i);
    }
  }
  throw std::runtime_error{fmt::format("the drawing has no joint named {}", name)};
}

Drawing parseRobot(const std::filesystem::path& file) {
  const json top = mergedFile(file);
  Drawing drawing;
  for (const auto& [name, length] : top.at("lengthsMillimetres").items()) {
    if (length.is_number()) {
      drawing.lengths[name] = 1e-3 * length.get<double>();
    }
  }
  std::map<std::string, Link> links{{"Torso", {}}};
  for (const json& entry : top.at("tree").at("links")) {
    const std::string name = entry.at("name").get<std::string>();
    if (entry.contains("parent")) {
      Link link = childOf(links.at(entry.at("parent").get<std::string>()), entry);
      if (entry.contains("joint")) {
        const std::string jointName = entry.at("joint").get<std::string>();
        drawing.joints.push_back(jointOf(top.at("joints").at(jointName), link, jointName));
        link.joint = static_cast<int>(drawing.joints.size()) - 1;
      }
      links[name] = link;
    }
  }
  for (const auto& [name, entry] : top.at("masses").items()) {
    if (entry.is_object()) {
      drawing.masses.push_back(
          {links.at(name).joint, entry.at("kilograms").get<double>(), vectorOf(entry.at("centreMillimetres"), 1e-3)});
    }
  }
  for (const char* name : {"top", "bottom"}) {
    const json& entry = top.at("cameras").at(name);
    drawing.cameras.push_back({name, links.at(entry.at("link").get<std::string>()).joint,
                               vectorOf(entry.at("originMillimetres"), 1e-3),
                               entry.at("pitchDegrees").get<double>() * radiansPerDegree});
  }
  readSoles(top.at("soles"), links, drawing);
  return drawing;
}

} // namespace blind
