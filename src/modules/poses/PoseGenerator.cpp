#include "poses/PoseGenerator.hpp"

#include "io/InputError.hpp"
#include "math/SubsetSelection.hpp"
#include "poses/RandomAttitude.hpp"

#include <fmt/format.h>

namespace naocal {

std::vector<Belief> stableAttitudes(const Robot& robot, const Scene& scene, const PoseOptions& options,
                                    std::size_t count) {
  RandomAttitude attitudes{robot, scene, options};
  std::vector<Belief> found;
  Sieve sieve;
  for (std::size_t tried = 0; tried < options.tries && found.size() < count; ++tried) {
    if (const auto attitude = attitudes.draw(sieve)) {
      found.push_back(attitude->belief);
    }
  }
  return found;
}

std::vector<PlannedPose> stablePoses(const Robot& robot, const std::vector<Board>& boards,
                                     const std::map<std::string, CameraIntrinsics>& cameras,
                                     const PoseOptions& options) {
  const Scene scene{robot, options.supportFoot, boards, cameras, options.sight};
  const std::vector<Belief> found = stableAttitudes(robot, scene, options, options.choice * options.count);
  if (found.size() < options.count) {
    throw InputError{fmt::format("expected {} stable poses that see a board, found {} in {} attempts; put the boards "
                                 "nearer or ask for fewer poses",
                                 options.count, found.size(), options.tries)};
  }
  std::vector<Eigen::MatrixXd> informations;
  for (const Belief& belief : found) {
    informations.push_back(scene.information(belief, posture(robot, belief)));
  }
  std::vector<PlannedPose> poses;
  for (const std::size_t chosen : mostInformative(scene.priorInformation(), informations, options.count)) {
    const Belief& belief = found[chosen];
    poses.push_back({options.supportFoot, belief.values.head(static_cast<Eigen::Index>(robot.joints.size())),
                     scene.sights(belief, posture(robot, belief))});
  }
  return poses;
}

} // namespace naocal
