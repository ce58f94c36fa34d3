#pragma once

#include "data/Capture.hpp"
#include "poses/NextPoses.hpp"
#include "poses/PosePlan.hpp"
#include "robot/Robot.hpp"

#include <array>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// POSES.json of a plan.
nlohmann::json planJson(const PosePlan& plan, const Robot& robot);

/// Writes each pose to `<folder>/<id>.pose`, as HULKs' robots read them: 26 angles in radians, joints in the drawing's
/// order, fingers behind their wrists.
void writePoseFiles(const PosePlan& plan, const Robot& robot, const std::filesystem::path& folder);

/// Reads such a file: angles per joint of the drawing [rad]. Throws InputError for one that does not hold 26 angles.
Eigen::VectorXd readAnglesFile(const std::filesystem::path& file, const Robot& robot);

/// Joints of a NAO that no drawing holds: fingers. Files name them, at rest.
inline constexpr std::array<std::string_view, 2> fingers{"LHand", "RHand"};

/// A pose as a file has it.
struct PlayablePose {
  std::string id;
  SupportFoot supportFoot = SupportFoot::left;
  Eigen::VectorXd angles;   // per joint, to be sent as they are [rad]
  Eigen::VectorXd approach; // per joint: the motion that ends in the pose, -1 from above, +1 from below, 0 any
};

/// POSES.json, as far as it takes to play it.
struct PoseFile {
  std::vector<PlayablePose> poses;         // in the order to take them
  std::map<std::string, Placement> boards; // where they lie, seen from the sole, by id; empty: the file does not say
  int firstStance = 0;                     // the number of the first stance that they are taken in
  double jointError = radians(6.5);        // of robots that stand in them and on the way (Stability) [rad]
};

/// Throws InputError for a file that is none, is of another robot, or holds angles that its joints cannot take.
PoseFile readPoseFile(const std::filesystem::path& file, const Robot& robot);

/// POSES.json of what was proposed.
nlohmann::json posesJson(const NextPoses& next, const Robot& robot);

/// The same as `next` of a diagnosis file: the poses and why.
nlohmann::json nextPosesJson(const NextPoses& next, const Robot& robot);

} // namespace naocal
