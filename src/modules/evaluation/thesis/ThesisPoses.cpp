#include "evaluation/thesis/ThesisPoses.hpp"

#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/SubsetSelection.hpp"
#include "poses/candidates/BoardPlacement.hpp"
#include "poses/candidates/PoseSampler.hpp"
#include "poses/criteria/PlannedInformation.hpp"
#include "poses/criteria/ThesisCriterion.hpp"

#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

const double offsetRange = radians(6.5); // of the offsets, either sign [rad]

/// Stable poses in which the robot sees a target.
std::vector<Eigen::VectorXd> candidatePoses(const Robot& robot, const ThesisScene& scenery, std::size_t count) {
  PoseOptions options;
  options.sight = scenery.limits;
  const PlanningScene scene{robot, options.supportFoot, scenery.targets, scenery.cameras, options.sight};
  std::vector<Eigen::VectorXd> poses;
  for (const ModelState& modelState : sampleStableStates(robot, scene, options, count)) {
    poses.emplace_back(modelState.values.head(eigenIndex(robot.joints.size())));
  }
  return poses;
}

std::size_t cornersSeen(const PoseGroup& pose, const Measurements& taken) {
  std::size_t corners = 0;
  for (const EncoderSample& reading : pose.readings) {
    for (const std::size_t picture : reading.pictures) {
      for (const BoardObservation& observation : taken.pictures[picture].observations) {
        corners += observation.ids.size();
      }
    }
  }
  return corners;
}

/// Value of a pose over robots with random offsets.
struct Prospect {
  Eigen::MatrixXd information; // about the offsets, mean over the robots
  bool sees = true;            // every robot sees enough corners
};

std::vector<Prospect> prospects(const ThesisExperiment& stage, const Model& model, const Noise& noise) {
  constexpr std::size_t robots = 40, enough = 24;
  const auto unknowns = eigenIndex(model.unknownCount());
  Measurements taken = stage.allObservations();
  std::vector<Prospect> result(taken.poses.size(), Prospect{Eigen::MatrixXd::Zero(unknowns, unknowns)});
  RandomStream chance{1, "robots before the thesis's poses"};
  const auto exact = [](double angle) { return AngleReading{angle, angle}; };
  for (std::size_t robot = 0; robot < robots; ++robot) {
    Eigen::VectorXd offsets{unknowns};
    for (double& offset : offsets) {
      offset = chance.uniformWithin(offsetRange);
    }
    stage.simulate(offsets, exact, 0, chance, taken);
    const Residuals residuals{taken, model, noise};
    const auto linear =
        residuals.linearize(residuals.startState(offsets)).value(); // visible corners are in front of the camera
    for (std::size_t pose = 0; pose < result.size(); ++pose) {
      PoseInformation told = marginalInformation(linear.poses[pose], noise);
      told.hessian /= robots;
      told.addTo(result[pose].information);
      result[pose].sees = result[pose].sees && cornersSeen(taken.poses[pose], taken) >= enough;
    }
  }
  return result;
}

/// The thesis's chain among the usable poses; returns indices into `usable`.
std::vector<std::size_t> chainOf(const Robot& robot, const ThesisExperiment& stage,
                                 const std::vector<Eigen::VectorXd>& poses, const std::vector<std::size_t>& usable,
                                 std::size_t count) {
  const ThesisCriterion thesis{
      robot, supportSole(robot, SupportFoot::left), nominalCameras(640, 480), stage.joints(), {}};
  std::vector<ValidPose> candidates;
  for (const std::size_t pose : usable) {
    candidates.push_back({nominalState(robot, StateLayout{robot.joints.size(), robot.lengths.size(), 0}), {}});
    candidates.back().modelState.values.head(poses[pose].size()) = poses[pose];
  }
  return thesis.selectChain(candidates, count);
}

} // namespace

std::vector<ThesisPose> posesForSetting(const ThesisSetting& setting, const Robot& robot,
                                        const std::vector<Eigen::VectorXd>& chosen) {
  std::vector<ThesisPose> result;
  for (std::size_t i = 0; i < setting.poses; ++i) {
    result.push_back({SupportFoot::left, chosen.at(i)});
  }
  for (std::size_t i = 0; setting.bothLegs && i < setting.poses; ++i) {
    result.push_back({SupportFoot::right, mirrorAngles(robot, chosen.at(i))});
  }
  return result;
}

Eigen::VectorXd anglesOfAll(const Robot& robot, const std::vector<std::string>& names, const Eigen::VectorXd& angles) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(eigenIndex(robot.joints.size()));
  for (std::size_t i = 0; i < names.size(); ++i) {
    all[eigenIndex(robot.jointIndex(names[i]).value())] = angles[eigenIndex(i)];
  }
  return all;
}

std::vector<Eigen::VectorXd> selectHeldOutPoses(const Robot& robot, const std::vector<std::string>& names,
                                                std::size_t count) {
  constexpr std::size_t candidates = 600;
  std::vector<std::size_t> motors;
  for (const std::string& name : names) {
    motors.push_back(robot.jointIndex(name).value());
  }
  const ThesisScene scenery = makeProgramScene({programGrid()});
  const SoleCamera<double> camera{robot, robot.cameraIndex("bottom").value(), robot.findSole("left")->link, motors,
                                  scenery.cameras.at("bottom")};
  std::vector<Eigen::VectorXd> result;
  for (const Eigen::VectorXd& pose : candidatePoses(robot, scenery, candidates)) {
    const Eigen::VectorXd angles = pose(std::vector<Eigen::Index>(motors.begin(), motors.end()));
    if (result.size() < count && passesHorizonTest(camera, camera.cameraFromSole(angles))) {
      result.push_back(angles);
    }
  }
  if (result.size() < count) {
    throw InputError{fmt::format("expected {} held-out poses that see the floor, found {} in {} stable ones", count,
                                 result.size(), candidates)};
  }
  return result;
}

std::vector<Eigen::VectorXd> selectThesisPoses(const Robot& robot, ThesisFeature feature, PoseChoice choice,
                                               std::size_t count) {
  if (choice == PoseChoice::program) {
    std::vector<Eigen::VectorXd> poses;
    for (const Eigen::VectorXd& angles : programPoses(programJoints())) {
      poses.push_back(anglesOfAll(robot, programJoints(), angles));
    }
    return poses;
  }
  constexpr std::size_t candidates = 300;
  const std::vector<Eigen::VectorXd> poses = candidatePoses(robot, makeThesisScene(feature, {}), candidates);
  const ThesisSetting drawn{.feature = feature, .poses = poses.size()};
  const ThesisExperiment stage{robot, drawn, posesForSetting(drawn, robot, poses)};
  const Model model = makeExperimentModel(stage, offsetRange / std::sqrt(3.0), 0);
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
                                 count, toString(feature), usable.size(), poses.size())};
  }
  const Eigen::MatrixXd prior = model.sigmas().cwiseAbs2().cwiseInverse().asDiagonal();
  std::vector<Eigen::VectorXd> result;
  for (const std::size_t chosen : choice == PoseChoice::chain ? chainOf(robot, stage, poses, usable, count)
                                                              : selectDOptimal(prior, informations, count)) {
    result.push_back(poses[usable[chosen]]);
  }
  return result;
}

} // namespace naocal
