#include "evaluate/ThesisPoses.hpp"

#include "evaluate/ThesisStage.hpp"
#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/SubsetSelection.hpp"
#include "poses/Mirror.hpp"
#include "poses/PlannedInformation.hpp"
#include "poses/PoseGenerator.hpp"
#include "poses/ThesisSelection.hpp"
#include "synthetic/SimulationPlan.hpp"

#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

const double range = radians(6.5); // of offsets [rad]

/// Attitudes in which a robot stands and sees something.
std::vector<Eigen::VectorXd> candidatePoses(const Robot& robot, const ThesisScenery& scenery, std::size_t count) {
  PoseOptions options;
  options.sight = scenery.limits;
  const Scene scene{robot, options.supportFoot, scenery.targets, scenery.cameras, options.sight};
  std::vector<Eigen::VectorXd> poses;
  for (const Belief& belief : stableAttitudes(robot, scene, options, count)) {
    poses.emplace_back(belief.values.head(at(robot.joints.size())));
  }
  return poses;
}

std::size_t cornersSeen(const PoseGroup& pose, const Measurements& taken) {
  std::size_t corners = 0;
  for (const Reading& reading : pose.readings) {
    for (const std::size_t picture : reading.pictures) {
      for (const Sighting& sighting : taken.pictures[picture].sightings) {
        corners += sighting.ids.size();
      }
    }
  }
  return corners;
}

/// What a pose is worth over robots with unknown offsets.
struct Prospect {
  Eigen::MatrixXd information; // about the offsets, on average
  bool sees = true;            // every robot sees enough
};

std::vector<Prospect> prospects(const ThesisStage& stage, const Model& model, const Noise& noise) {
  constexpr std::size_t robots = 40, enough = 24;
  const auto unknowns = at(model.unknownCount());
  Measurements taken = stage.everything();
  std::vector<Prospect> result(taken.poses.size(), Prospect{Eigen::MatrixXd::Zero(unknowns, unknowns)});
  Randomness chance{1, "robots before the thesis's poses"};
  const auto exact = [](double angle) { return AngleReading{angle, angle}; };
  for (std::size_t robot = 0; robot < robots; ++robot) {
    Eigen::VectorXd offsets{unknowns};
    for (double& offset : offsets) {
      offset = chance.within(range);
    }
    stage.take(offsets, exact, 0, chance, taken);
    const Residuals residuals{taken, model, noise};
    const auto linear = residuals.linearised(residuals.start(offsets)).value(); // what is seen lies before the camera
    for (std::size_t pose = 0; pose < result.size(); ++pose) {
      PoseInformation told = informationOf(linear.poses[pose], noise);
      told.hessian /= robots;
      told.addTo(result[pose].information);
      result[pose].sees = result[pose].sees && cornersSeen(taken.poses[pose], taken) >= enough;
    }
  }
  return result;
}

/// The thesis's chain among the usable poses; their numbers.
std::vector<std::size_t> chainOf(const Robot& robot, const ThesisStage& stage,
                                 const std::vector<Eigen::VectorXd>& poses, const std::vector<std::size_t>& usable,
                                 std::size_t count) {
  const ThesisSelection thesis{
      robot, supportSole(robot, SupportFoot::left), drawnCameras(640, 480), stage.joints(), {}};
  std::vector<SievedPose> candidates;
  for (const std::size_t pose : usable) {
    candidates.push_back({drawnBelief(robot, Quantities{robot.joints.size(), robot.lengths.size(), 0}), {}});
    candidates.back().belief.values.head(poses[pose].size()) = poses[pose];
  }
  return thesis.chain(candidates, count);
}

} // namespace

std::vector<ThesisPose> posesOf(const ThesisSetting& setting, const Robot& robot,
                                const std::vector<Eigen::VectorXd>& chosen) {
  std::vector<ThesisPose> result;
  for (std::size_t i = 0; i < setting.poses; ++i) {
    result.push_back({SupportFoot::left, chosen.at(i)});
  }
  for (std::size_t i = 0; setting.bothLegs && i < setting.poses; ++i) {
    result.push_back({SupportFoot::right, mirrored(robot, chosen.at(i))});
  }
  return result;
}

std::vector<Eigen::VectorXd> thesisPoses(const Robot& robot, ThesisFeature feature, PoseChoice choice,
                                         std::size_t count) {
  constexpr std::size_t candidates = 300;
  const std::vector<Eigen::VectorXd> poses = candidatePoses(robot, thesisScenery(feature), candidates);
  const ThesisSetting drawn{.feature = feature, .poses = poses.size()};
  const ThesisStage stage{robot, drawn, posesOf(drawn, robot, poses)};
  const Model model = unknownsOf(stage, range / std::sqrt(3.0), 0);
  const std::vector<Prospect> all = prospects(stage, model, Noise{});
  std::vector<std::size_t> usable;
  std::vector<Eigen::MatrixXd> informations;
  for (std::size_t pose = 0; pose < poses.size(); ++pose) {
    if (all[pose].sees) {
      usable.push_back(pose);
      informations.push_back(all[pose].information);
    }
  }
  if (usable.size() < count) {
    throw InputError{fmt::format("expected {} poses that see the {} despite wrong offsets, found {} in {} stable ones",
                                 count, word(feature), usable.size(), poses.size())};
  }
  const Eigen::MatrixXd prior = model.sigmas().cwiseAbs2().cwiseInverse().asDiagonal();
  std::vector<Eigen::VectorXd> result;
  for (const std::size_t chosen : choice == PoseChoice::chain ? chainOf(robot, stage, poses, usable, count)
                                                              : mostInformative(prior, informations, count)) {
    result.push_back(poses[usable[chosen]]);
  }
  return result;
}

} // namespace naocal
