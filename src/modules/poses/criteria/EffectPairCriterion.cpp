#include "poses/criteria/EffectPairCriterion.hpp"

#include "estimation/ModelBuilder.hpp"
#include "io/InputError.hpp"
#include "math/SubsetSelection.hpp"
#include "poses/criteria/Discrimination.hpp"
#include "poses/criteria/PlanOptions.hpp"
#include "poses/criteria/PlannedInformation.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal {

EffectPairCriterion::EffectPairCriterion(const Robot& robot, const std::vector<Board>& boards,
                                         const std::map<std::string, CameraIntrinsics>& cameras,
                                         const PlanOptions& options)
    : robot_{robot}, boards_{boards}, cameras_{cameras}, options_{options}, scene_{robot, options.poses.supportFoot,
                                                                                   boards, cameras,
                                                                                   options.poses.sight} {
  if (options.effects.size() != 2) {
    throw InputError{fmt::format("expected two effects to tell apart, such as elasticity@LKneePitch,"
                                 "backlash@LKneePitch, found {}",
                                 options.effects.size())};
  }
}

/// One image per camera and pose, at a known stance; corner coordinates are irrelevant.
CaptureSet EffectPairCriterion::captures(const std::vector<ValidPose>& poses) const {
  CaptureSet set{.name = "plan", .model = robot_.model, .cameras = cameras_, .boards = boards_};
  set.stances = {{0, options_.poses.supportFoot, Placement{}}};
  for (const Joint& joint : robot_.joints) {
    set.jointNames.push_back(joint.name);
  }
  for (Board& board : set.boards) {
    if (!options_.known) {
      board.placementGuess = *board.placement;
      board.hasGuess = true;
      board.placement.reset();
    }
  }
  const auto joints = static_cast<Eigen::Index>(robot_.joints.size());
  std::mt19937_64 random{options_.poses.seed};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::VectorXd approach = poses[i].approach.size() > 0 ? poses[i].approach : drawApproach(robot_, random);
    ModelState modelState = scene_.nominalState();
    modelState.values.head(joints) = poses[i].modelState.values.head(joints);
    const std::vector<VisibleBoard> sights = scene_.visibleBoards(modelState, forwardKinematics(robot_, modelState));
    for (const auto& [camera, lens] : cameras_) {
      Capture& capture = set.captures.emplace_back();
      capture.id = static_cast<int>(set.captures.size());
      capture.pose = plannedPoseName(i);
      capture.camera = camera;
      capture.supportFoot = options_.poses.supportFoot;
      capture.joints.measured.assign(modelState.values.begin(), modelState.values.begin() + joints);
      capture.joints.approach.assign(approach.begin(), approach.end());
      capture.corners = cornersSeenBy(camera, sights);
    }
  }
  return set;
}

EffectPairCriterion::Told EffectPairCriterion::tellApart(const std::vector<ValidPose>& poses) const {
  const Measurements measurements = buildMeasurements({captures(poses)}, robot_);
  const std::vector<std::string> without =
      options_.known ? std::vector<std::string>{"cameraRotation@*"} : std::vector<std::string>{};
  const Model own = buildModel(measurements, {}, without);
  Told result{static_cast<Eigen::Index>(own.unknownCount()), {}, false, {}, {}};
  result.question.rivals = true;
  result.question.effects = allEffects();
  const Model named = buildModel(measurements, options_.effects, without); // throws for invalid effects
  const auto isAsked = [&](const Term& term) {
    return std::any_of(options_.effects.begin(), options_.effects.end(), [&](const std::string& given) {
      return given == term.label() ||
             (term.effect.placeKind == PlaceKind::motor && labelFor(given, robot_) == term.label());
    });
  };
  for (const Term& term : named.terms()) {
    if (isAsked(term)) {
      result.question.suspects.push_back({term.label(), term.sigmas(), term.sigmas(), 0.5});
    }
  }
  const Model model = addHypotheses(measurements, own, result.question);
  result.byApproach = dependsOnApproach(model);
  result.prior = model.sigmas().cwiseAbs2().cwiseInverse().asDiagonal();
  result.poses.assign(poses.size(), Eigen::MatrixXd::Zero(result.prior.rows(), result.prior.cols()));
  const Residuals residuals{measurements, model, options_.noise};
  const Eigen::VectorXd asDrawn = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.unknownCount()));
  const auto linear =
      residuals.linearize(residuals.startState(asDrawn)).value(); // visible corners are in front of the camera
  std::map<std::string, std::size_t> numbers;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    numbers[plannedPoseName(i)] = i;
  }
  for (std::size_t pose = 0; pose < linear.poses.size(); ++pose) {
    marginalInformation(linear.poses[pose], options_.noise)
        .addTo(result.poses[numbers.at(measurements.poses[pose].name)]);
  }
  return result;
}

std::vector<ValidPose> EffectPairCriterion::selectPoses(const std::vector<ValidPose>& kept,
                                                        const std::vector<ValidPose>& candidates,
                                                        std::size_t count) const {
  std::vector<ValidPose> all = kept;
  std::mt19937_64 random{options_.poses.seed};
  for (const ValidPose& candidate : candidates) {
    all.push_back(candidate);
    all.back().approach = drawApproach(robot_, random);
    all.push_back(all.back());
    all.back().approach *= -1;
  }
  Told told = this->tellApart(all);
  const Discrimination discrimination{told.question, told.own};
  Eigen::MatrixXd known = told.prior;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    known += told.poses[i];
  }
  told.poses.erase(told.poses.begin(), told.poses.begin() + static_cast<std::ptrdiff_t>(kept.size()));
  const Eigen::VectorXd before = discrimination.misfits(told.prior);
  const Objective judge = [&](const Eigen::MatrixXd& sum) {
    return 1 / discrimination.growthFactor(before, discrimination.misfits(sum));
  };
  std::vector<std::size_t> chosen = selectGreedily(judge, known, told.poses, count);
  improveByExchange(judge, known, told.poses, chosen);
  std::vector<ValidPose> result;
  for (const std::size_t index : chosen) {
    result.push_back(all[kept.size() + index]);
    if (!told.byApproach) {
      result.back().approach.resize(0);
    }
  }
  return result;
}

double EffectPairCriterion::misfit(const std::vector<ValidPose>& kept, const std::vector<ValidPose>& poses) const {
  std::vector<ValidPose> all = kept;
  all.insert(all.end(), poses.begin(), poses.end());
  const Told told = this->tellApart(all);
  Eigen::MatrixXd sum = told.prior;
  for (const Eigen::MatrixXd& pose : told.poses) {
    sum += pose;
  }
  const Eigen::VectorXd misfits = Discrimination{told.question, told.own}.misfits(sum);
  return misfits.size() == 0 ? 0 : misfits.minCoeff();
}

} // namespace naocal
