#pragma once

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace blind {

inline constexpr double radiansPerDegree = std::numbers::pi / 180;

/// Contents of a drawing file, in metres and radians. All frames are parallel to the torso's at zero angles, so
/// positions are sums of vectors.
struct Drawing {
  struct Row {
    double other, lower, upper; // [rad]
  };
  struct Joint {
    std::string name;
    int parent = -1;                                     // joint that moves the link carrying this one; -1: torso
    Eigen::Vector3d axis;                                // unit vector
    Eigen::Vector3d fixedPlace;                          // at zero angles in the torso's frame, without lengths [m]
    std::map<std::string, Eigen::Vector3d> alongLengths; // place = fixedPlace + sum of length * direction
    double lower = 0, upper = 0, resting = 0;            // [rad]
    std::string coupledTo;
    std::vector<Row> coupled;
    std::string drivenBy; // joint whose motor drives this one too
  };
  struct Mass {
    int joint = -1;
    double kilograms = 0;
    Eigen::Vector3d inLink; // [m]
  };
  struct Camera {
    std::string name;
    int joint = -1;
    Eigen::Vector3d inLink; // [m]
    double pitch = 0;       // [rad], turned down
  };
  struct Sole {
    int joint = -1;
    std::vector<Eigen::Vector2d> outline; // in the sole's frame, counter-clockwise [m]
  };

  std::map<std::string, double> lengths; // [m]
  std::vector<Joint> joints;             // parents first
  std::vector<Mass> masses;
  std::vector<Camera> cameras; // top, bottom
  std::array<Sole, 2> soles;   // left, right; each footZ below its joint

  int joint(const std::string& name) const; // index; throws for an unknown name
};

/// Reads NaoV4, V5 or V6 (a drawing may name a base and contain only the differences).
Drawing parseRobot(const std::filesystem::path& file);

} // namespace blind
