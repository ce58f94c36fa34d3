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

/// The numbers of a drawing file, as the file has them but in metres and radians. All frames are parallel to the
/// torso's at zero angles, so a place there is a sum of vectors.
struct Drawing {
  struct Row {
    double other, lower, upper; // [rad]
  };
  struct Joint {
    std::string name;
    int parent = -1;            // the joint that moves the link which carries this one; -1: the torso
    Eigen::Vector3d axis;       // unit vector
    Eigen::Vector3d fixedPlace; // at zero angles in the torso's frame, lengths left out [m]
    std::map<std::string, Eigen::Vector3d> alongLengths; // place = fixedPlace + sum of length * direction
    double lower = 0, upper = 0, resting = 0;            // [rad]
    std::string coupledTo;
    std::vector<Row> coupled;
    std::string drivenBy; // the joint whose motor moves this one too
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
  std::array<Sole, 2> soles;   // left, right; each a length footZ below its joint

  int joint(const std::string& name) const; // its index; throws for a name that is none
};

/// Reads NaoV4, V5 or V6 (a drawing may name another as its base and hold only what differs).
Drawing parseRobot(const std::filesystem::path& file);

} // namespace blind
