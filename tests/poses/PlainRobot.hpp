#pragma once

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

/// A robot as described in its drawing, implemented without src/modules, to validate the modules.
namespace plain {

using Json = nlohmann::json;
using Angles = std::map<std::string, double>; // [rad]
constexpr double degree = 3.14159265358979323846 / 180;

inline Json drawing(const std::string& model) {
  const std::string folder = std::string{NAOCAL_SOURCE_DIR} + "/home/configuration/drawings/";
  Json own = Json::parse(std::ifstream{folder + "Nao" + model + ".json"});
  if (!own.contains("base")) {
    return own;
  }
  Json whole = Json::parse(std::ifstream{folder + own["base"].get<std::string>()});
  whole.merge_patch(own);
  return whole;
}

inline Eigen::Vector3d metres(const Json& millimetres) {
  return Eigen::Vector3d{millimetres[0].get<double>(), millimetres[1].get<double>(), millimetres[2].get<double>()} /
         1000;
}

/// torsoFromLink by link name.
inline std::map<std::string, Eigen::Isometry3d> posture(const Json& robot, const Angles& angles) {
  std::map<std::string, Eigen::Isometry3d> result;
  for (const Json& link : robot["tree"]["links"]) {
    Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
    if (link.contains("parent")) {
      at = result.at(link["parent"].get<std::string>());
    }
    if (link.contains("originMillimetres")) {
      at.translate(metres(link["originMillimetres"]));
    }
    if (link.contains("alongLengths")) {
      for (const auto& [name, direction] : link["alongLengths"].items()) {
        const double length = robot["lengthsMillimetres"][name].get<double>() / 1000;
        at.translate(length * Eigen::Vector3d{direction[0].get<double>(), direction[1].get<double>(),
                                              direction[2].get<double>()});
      }
    }
    if (link.contains("joint")) {
      const std::string joint = link["joint"].get<std::string>();
      const Json& axis = robot["joints"][joint]["axis"];
      at.rotate(Eigen::AngleAxisd{
          angles.at(joint),
          Eigen::Vector3d{axis[0].get<double>(), axis[1].get<double>(), axis[2].get<double>()}.normalized()});
    }
    result[link["name"].get<std::string>()] = at;
  }
  return result;
}

/// Centre of mass in the torso's frame [m].
inline Eigen::Vector3d centreOfMass(const Json& robot, const std::map<std::string, Eigen::Isometry3d>& links) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double mass = 0;
  for (const auto& [name, part] : robot["masses"].items()) {
    if (part.is_object()) {
      const double kilograms = part["kilograms"].get<double>();
      sum += kilograms * (links.at(name) * metres(part["centreMillimetres"]));
      mass += kilograms;
    }
  }
  return sum / mass;
}

/// Outline of a sole, counter-clockwise, in its frame [m].
inline std::vector<Eigen::Vector3d> outline(const Json& robot, const std::string& side) {
  const Json& sole = robot["soles"][side];
  std::vector<Eigen::Vector3d> corners;
  if (sole.contains("outlineMirroredFrom")) {
    corners = outline(robot, sole["outlineMirroredFrom"].get<std::string>());
    for (Eigen::Vector3d& corner : corners) {
      corner.y() = -corner.y();
    }
    std::reverse(corners.begin(), corners.end());
    return corners;
  }
  for (const Json& corner : sole["outlineMillimetres"]) {
    corners.emplace_back(corner[0].get<double>() / 1000, corner[1].get<double>() / 1000, 0);
  }
  return corners;
}

/// Whether a point lies to the left of every side of a counter-clockwise outline.
inline bool inside(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& point) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d side = corners[(i + 1) % corners.size()] - corners[i], to = point - corners[i];
    if (side.x() * to.y() - side.y() * to.x() < 0) {
      return false;
    }
  }
  return true;
}

/// Transforms a sole's corners into the other sole's frame.
inline std::vector<Eigen::Vector3d> placed(const std::vector<Eigen::Vector3d>& corners, const Eigen::Isometry3d& from) {
  std::vector<Eigen::Vector3d> result;
  for (const Eigen::Vector3d& corner : corners) {
    result.push_back(from * corner);
  }
  return result;
}

/// Corners of the right sole in the left one's frame [m].
inline std::vector<Eigen::Vector3d> rightSole(const Json& robot, const Angles& angles) {
  const auto links = posture(robot, angles);
  return placed(outline(robot, "right"), links.at(robot["soles"]["left"]["link"].get<std::string>()).inverse() *
                                             links.at(robot["soles"]["right"]["link"].get<std::string>()));
}

/// Whether the robot stands on both soles: in the plane fitted to their corners, no line through the projected centre
/// of mass has all corners on one side.
inline bool standsOnBoth(const Json& robot, const Angles& angles) {
  const auto links = posture(robot, angles);
  std::vector<Eigen::Vector3d> corners;
  for (const char* side : {"left", "right"}) {
    const auto own = placed(outline(robot, side), links.at(robot["soles"][side]["link"].get<std::string>()));
    corners.insert(corners.end(), own.begin(), own.end());
  }
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : corners) {
    middle += corner / static_cast<double>(corners.size());
  }
  Eigen::MatrixXd about(corners.size(), 3);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    about.row(static_cast<Eigen::Index>(i)) = (corners[i] - middle).transpose();
  }
  const Eigen::Vector3d up = Eigen::JacobiSVD<Eigen::MatrixXd>{about, Eigen::ComputeThinV}.matrixV().col(2);
  const Eigen::Vector3d centre = centreOfMass(robot, links), x = up.unitOrthogonal(), y = up.cross(x);
  std::vector<double> directions;
  for (const Eigen::Vector3d& corner : corners) {
    directions.push_back(std::atan2(y.dot(corner - centre), x.dot(corner - centre)));
  }
  std::sort(directions.begin(), directions.end());
  double widest = directions.front() + 360 * degree - directions.back();
  for (std::size_t i = 1; i < directions.size(); ++i) {
    widest = std::max(widest, directions[i] - directions[i - 1]);
  }
  return widest < 180 * degree;
}

/// Whether the robot stands on one flat sole with the other one lifted, or on both.
inline bool stands(const Json& robot, const std::string& side, const Angles& angles) {
  if (side == "both") {
    return standsOnBoth(robot, angles);
  }
  const std::string other = side == "left" ? "right" : "left";
  const auto links = posture(robot, angles);
  const Eigen::Isometry3d soleFromTorso = links.at(robot["soles"][side]["link"].get<std::string>()).inverse();
  const Eigen::Isometry3d soleFromOther = soleFromTorso * links.at(robot["soles"][other]["link"].get<std::string>());
  for (const Eigen::Vector3d& corner : outline(robot, other)) {
    if ((soleFromOther * corner).z() <= 0) {
      return false;
    }
  }
  return inside(outline(robot, side), soleFromTorso * centreOfMass(robot, links));
}

/// Whether all angles keep `margin` from their limits, including coupled ones; hanging arms need no margin.
inline bool withinLimits(const Json& robot, const Angles& angles, double margin) {
  for (const auto& [name, joint] : robot["joints"].items()) {
    if (!joint.is_object()) {
      continue;
    }
    const bool arm = name.find("Shoulder") != std::string::npos || name.find("Elbow") != std::string::npos ||
                     name.find("Wrist") != std::string::npos;
    double lower = joint["limitsDegrees"][0].get<double>(), upper = joint["limitsDegrees"][1].get<double>();
    if (joint.contains("coupledLimits")) {
      const Json& coupled = joint["coupledLimits"];
      const double on = angles.at(coupled["on"].get<std::string>()) / degree;
      const Json& rows = coupled["rowsDegrees"];
      std::size_t i = 0;
      while (i + 2 < rows.size() && on > rows[i + 1][0].get<double>()) {
        ++i;
      }
      const double from = rows[i][0].get<double>(), to = rows[i + 1][0].get<double>();
      const double share = std::clamp((on - from) / (to - from), 0.0, 1.0);
      const auto at = [&](int column) {
        return rows[i][column].get<double>() +
               share * (rows[i + 1][column].get<double>() - rows[i][column].get<double>());
      };
      lower = std::max(lower, at(1));
      upper = std::min(upper, at(2));
    }
    const double angle = angles.at(name) / degree, own = arm ? -1e-6 : margin / degree - 1e-6;
    if (angle < lower + own || angle > upper - own) {
      return false;
    }
  }
  return true;
}

} // namespace plain
