#pragma once

#include "data/Capture.hpp"
#include "poses/CapturePlan.hpp"
#include "poses/NextPoses.hpp"
#include "poses/PosePlan.hpp"
#include "robot/Robot.hpp"

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// Id of the pose at a place of a plan: L00 on the left foot, R01, B02 on both, P03 of a robot whose base stands.
std::string poseId(const ProposedPose& pose, std::size_t index);

/// POSES.json of a plan.
nlohmann::json planJson(const PosePlan& plan, const Robot& robot);
nlohmann::json planJson(const CapturePlan& plan, const Robot& robot);

/// Writes each pose to `<folder>/<id>.pose` in HULKs' format: 26 angles [rad], joints in the drawing's order, each hand
/// after its wrist.
void writePoseFiles(const PosePlan& plan, const Robot& robot, const std::filesystem::path& folder);

/// Reads a .pose file: angles per joint of the drawing [rad]. Throws InputError unless it holds 26 angles.
Eigen::VectorXd readAnglesFile(const std::filesystem::path& file, const Robot& robot);

/// A pose read from a file.
struct PlayablePose {
  std::string id;
  SupportFoot supportFoot = SupportFoot::left; // none: its base, or soles that its set names
  Eigen::VectorXd angles;                      // per joint, motor command without offsets [rad]
  Eigen::VectorXd approach; // per joint: direction of the final motion, -1 from above, +1 from below, 0 any
};

/// Contents of POSES.json needed to play it.
struct PoseFile {
  std::vector<PlayablePose> poses;         // in playing order
  std::map<std::string, Placement> boards; // placement relative to the sole, by id; empty: not in the file
  int firstStance = 0;                     // id of the first stance
  double jointError = radians(6.5); // joint error tolerated in the poses and on the ways (BalanceRequirement) [rad]
};

/// Throws InputError for an invalid file, another robot model, or angles beyond joint limits.
PoseFile readPoseFile(const std::filesystem::path& file, const Robot& robot);

/// POSES.json of proposed poses.
nlohmann::json posesJson(const NextPoses& next, const Robot& robot);

/// The poses and the reason for them, as `next` of a diagnosis file.
nlohmann::json nextPosesJson(const NextPoses& next, const Robot& robot);

} // namespace naocal
