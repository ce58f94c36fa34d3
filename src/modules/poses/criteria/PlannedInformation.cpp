#include "poses/criteria/PlannedInformation.hpp"

#include "estimation/CandidateTerms.hpp"
#include "estimation/DriverState.hpp"
#include "estimation/Model.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>

namespace naocal {

namespace {

/// Footing of the fitted robot: half of the drawn robot's, for the uncertainty of the fit.
constexpr SupportMargin fittedFooting{0.01, 0.01};

/// In the order of the set's joints; 0 for joints not in the drawing (hands).
std::vector<double> listAngles(const CaptureSet& set, const Robot& robot, const Eigen::VectorXd& perJoint) {
  std::vector<double> result;
  for (const std::string& name : set.jointNames) {
    const auto joint = robot.jointIndex(name);
    result.push_back(joint ? perJoint[static_cast<Eigen::Index>(*joint)] : 0);
  }
  return result;
}

/// The fit's unknowns, mapped to the extended model; new stances are at the last stance's place.
Eigen::VectorXd extendUnknowns(const FittedModel& fitted, const Measurements& extended, const Model& model,
                               const std::vector<LocalScene>& around) {
  Eigen::VectorXd result = mapParameters(fitted.model, fitted.fit.unknowns, model);
  for (const Term& term : model.terms()) {
    if (term.effect.placeKind != PlaceKind::stance || fitted.model.find(term.label())) {
      continue;
    }
    for (const LocalScene& here : around) {
      if (here.supportFoot == extended.stances[term.placeIndex].supportFoot) {
        result.segment<3>(static_cast<Eigen::Index>(term.first)) << here.sole.x, here.sole.y, here.sole.yaw;
      }
    }
  }
  return result;
}

/// Transforms a placement on the floor to the frame of another one.
Placement seenFrom(const Placement& sole, const Placement& board) {
  const double x = board.x - sole.x, y = board.y - sole.y, c = std::cos(sole.yaw), s = std::sin(sole.yaw);
  Placement result;
  result.x = c * x + s * y;
  result.y = c * y - s * x;
  result.yaw = wrapAngle(board.yaw - sole.yaw);
  return result;
}

template <typename Numbers> Placement onFloor(const Numbers& numbers) {
  Placement result;
  result.x = numbers[0];
  result.y = numbers[1];
  result.yaw = numbers[5];
  return result;
}

} // namespace

Capture plannedCapture(const CaptureSet& set, const Robot& robot, const Eigen::VectorXd& angles,
                       const Eigen::VectorXd& approach) {
  const Capture& last = set.captures.back();
  Capture capture;
  capture.time = last.time + Seconds{30};
  capture.supportFoot = last.supportFoot;
  capture.joints.measured = listAngles(set, robot, angles);
  if (!last.joints.velocity.empty()) {
    capture.joints.velocity.assign(set.jointNames.size(), 0);
  }
  if (!last.joints.approach.empty()) {
    capture.joints.approach = listAngles(set, robot, approach);
  }
  capture.joints.temperature = last.joints.temperature;
  capture.joints.current = last.joints.current;
  capture.imu = last.imu;
  capture.fsr = last.fsr;
  return capture;
}

Eigen::VectorXd drawApproach(const Robot& robot, std::mt19937_64& random) {
  Eigen::VectorXd result(eigenIndex(robot.joints.size()));
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const double drawn = random() % 2 == 0 ? 1 : -1;
    const std::size_t motor = robot.joints[joint].motor;
    result[eigenIndex(joint)] = motor < joint ? result[eigenIndex(motor)] : drawn;
  }
  return result;
}

bool dependsOnApproach(const Model& model) {
  return std::any_of(model.terms().begin(), model.terms().end(), [](const Term& term) {
    const auto& needs = term.effect.drivers;
    return std::find(needs.begin(), needs.end(), Driver::approach) != needs.end();
  });
}

std::vector<BoardCorners> cornersSeenBy(const std::string& camera, const std::vector<VisibleBoard>& sights) {
  std::vector<BoardCorners> result;
  for (const VisibleBoard& sight : sights) {
    if (sight.camera == camera) {
      const std::vector<Eigen::Vector2d> nothing(sight.corners.size(), Eigen::Vector2d::Zero());
      result.push_back({sight.board, sight.corners, nothing});
    }
  }
  return result;
}

std::string plannedPoseName(std::size_t pose) {
  return fmt::format("planned {:06}", pose);
}

int plannedStanceId(const std::vector<CaptureSet>& sets, SupportFoot foot) {
  int highest = -1;
  for (const CaptureSet& set : sets) {
    for (const Stance& stance : set.stances) {
      highest = std::max(highest, stance.id);
    }
  }
  return highest + (foot == SupportFoot::left ? 1 : 2);
}

std::vector<CaptureSet> appendPlannedCaptures(const std::vector<CaptureSet>& sets, const Robot& robot,
                                              const std::vector<ProposedPose>& poses) {
  std::vector<CaptureSet> result = sets;
  CaptureSet& set = result.back();
  for (const SupportFoot foot : {SupportFoot::left, SupportFoot::right}) {
    set.stances.push_back({plannedStanceId(sets, foot), foot, std::nullopt});
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    Capture capture = plannedCapture(sets.back(), robot, poses[i].pose.angles, poses[i].approach);
    capture.supportFoot = poses[i].pose.supportFoot;
    capture.pose = plannedPoseName(i);
    capture.stance = plannedStanceId(sets, capture.supportFoot);
    for (const auto& [camera, lens] : set.cameras) {
      capture.camera = camera;
      capture.corners = cornersSeenBy(camera, poses[i].pose.sights);
      set.captures.push_back(capture);
    }
  }
  return result;
}

std::vector<ProposedPose> filterFeasible(const FittedModel& fitted, const std::vector<LocalScene>& around,
                                         std::vector<ProposedPose> poses) {
  const Measurements& measurements = fitted.measurements;
  const Robot& robot = measurements.robot;
  std::map<SupportFoot, PlanningScene> scenes;
  for (const LocalScene& here : around) {
    scenes.try_emplace(here.supportFoot, robot, here.supportFoot, here.boards, measurements.sets->back().cameras,
                       VisibilityLimits{});
  }
  std::map<std::size_t, ImageObservation> pictures; // last image per camera; only its angles are changed
  for (const ImageObservation& picture : measurements.pictures) {
    pictures.insert_or_assign(picture.camera, picture);
  }
  const auto ofRobot = static_cast<Eigen::Index>(measurements.quantities.lens()); // angles, lengths, mount
  for (ProposedPose& planned : poses) {
    PlannedPose& pose = planned.pose;
    const PlanningScene& scene = scenes.at(pose.supportFoot);
    pose.sights.clear();
    for (auto& [camera, picture] : pictures) {
      picture.instant.supportFoot = pose.supportFoot;
      picture.instant.q = pose.angles;
      picture.nominal.values.head(pose.angles.size()) = pose.angles;
      ModelState modelState = scene.nominalState();
      modelState.values.head(ofRobot) =
          predictState(measurements, fitted.model, picture, fitted.fit.unknowns).values.head(ofRobot);
      const LinkPoses torsoFromLink = forwardKinematics(robot, modelState);
      if (!isBalanced(robot, torsoFromLink, pose.supportFoot, fittedFooting)) {
        break;
      }
      for (VisibleBoard& sight : scene.visibleBoards(modelState, torsoFromLink)) {
        if (sight.camera == robot.cameras[camera].name) {
          pose.sights.push_back(std::move(sight));
        }
      }
    }
  }
  std::erase_if(poses, [](const ProposedPose& planned) { return planned.pose.sights.empty(); });
  return poses;
}

double samplesPerPose(const Measurements& measurements) {
  std::size_t pictures = 0;
  std::set<std::pair<const PoseGroup*, std::size_t>> views;
  for (const PoseGroup& pose : measurements.poses) {
    for (const EncoderSample& reading : pose.readings) {
      for (const std::size_t picture : reading.pictures) {
        ++pictures;
        views.insert({&pose, measurements.pictures[picture].camera});
      }
    }
  }
  return std::round(static_cast<double>(pictures) / static_cast<double>(views.size()));
}

Model addHypotheses(const Measurements& measurements, const Model& model, const ModelAmbiguity& question) {
  Model result = model;
  const std::vector<Term> terms = candidateTerms(measurements, question.effects);
  for (const Hypothesis& suspect : question.suspects) {
    const auto term =
        std::find_if(terms.begin(), terms.end(), [&](const Term& each) { return each.label() == suspect.label; });
    if (term == terms.end()) {
      throw InputError{fmt::format("{} has no place in these captures", suspect.label)};
    }
    result.add(*term);
  }
  return result;
}

void PoseInformation::addTo(Eigen::MatrixXd& sum) const {
  sum(unknowns, unknowns) += hessian;
}

PoseInformation marginalInformation(PoseSystem pose, const Noise& noise, double samples) {
  pose.unknownGram *= samples;
  pose.jointErrorCross *= samples;
  pose.jointErrorGram *= samples;
  return {pose.unknowns, marginalize(pose, noise, jointErrorRoot(pose, noise)).hessian};
}

PlannedInformation linearizePlans(const Measurements& extended, const Model& model, const Noise& noise,
                                  const Eigen::VectorXd& unknowns, std::size_t planned, double samples) {
  const Residuals residuals{extended, model, noise};
  const auto linear = residuals.linearize(residuals.startState(unknowns));
  if (!linear) {
    throw InputError{"the fit puts a corner that was seen behind the camera: these captures do not belong together"};
  }
  std::map<std::string, std::size_t> numbers;
  for (std::size_t i = 0; i < planned; ++i) {
    numbers[plannedPoseName(i)] = i;
  }
  PlannedInformation result;
  result.known = model.sigmas().cwiseAbs2().cwiseInverse().asDiagonal();
  result.promised.resize(planned);
  for (std::size_t pose = 0; pose < linear->poses.size(); ++pose) {
    if (const auto found = numbers.find(extended.poses[pose].name); found != numbers.end()) {
      result.promised[found->second] = marginalInformation(linear->poses[pose], noise, samples);
    } else {
      marginalInformation(linear->poses[pose], noise).addTo(result.known);
    }
  }
  return result;
}

PlannedInformation predictInformation(const FittedModel& fitted, const ModelAmbiguity& question,
                                      const std::vector<LocalScene>& around, const std::vector<ProposedPose>& poses) {
  const Measurements& measurements = fitted.measurements;
  const Measurements extended = buildMeasurements(appendPlannedCaptures(*measurements.sets, measurements.robot, poses),
                                                  measurements.robot, measurements.samePlace);
  Model own = buildModel(extended, question.with, question.without, question.effects);
  const Model model = addHypotheses(extended, own, question);
  PlannedInformation result =
      linearizePlans(extended, model, fitted.fit.noise, extendUnknowns(fitted, extended, model, around), poses.size(),
                     samplesPerPose(measurements));
  result.own = std::move(own);
  return result;
}

std::vector<LocalScene> findLocalScenes(const FittedModel& fitted) {
  const Measurements& measurements = fitted.measurements;
  const std::size_t lastSet = measurements.sets->size() - 1;
  std::map<SupportFoot, const ImageObservation*> latest; // per foot
  std::set<std::size_t> seen;
  for (const ImageObservation& picture : measurements.pictures) {
    const SupportFoot foot =
        picture.instant.supportFoot == SupportFoot::both ? SupportFoot::left : picture.instant.supportFoot;
    if (picture.set != lastSet || foot == SupportFoot::none) {
      continue;
    }
    const ImageObservation*& last = latest[foot];
    last = !last || last->instant.time < picture.instant.time ? &picture : last;
    for (const BoardObservation& observation : picture.observations) {
      if (measurements.targets[observation.view.board()].inWorld) {
        seen.insert(observation.view.board());
      }
    }
  }
  std::vector<LocalScene> result;
  for (const auto& [foot, picture] : latest) {
    const ModelState modelState = predictState(measurements, fitted.model, *picture, fitted.fit.unknowns);
    LocalScene here{foot, onFloor(modelState.worldFromSupport()), {}};
    for (const std::size_t target : seen) {
      Board board = measurements.targets[target].board; // keeps the id used in its set
      board.placement = seenFrom(here.sole, onFloor(modelState.boardPlacement(target)));
      here.boards.push_back(std::move(board));
    }
    if (!here.boards.empty()) {
      result.push_back(std::move(here));
    }
  }
  return result;
}

} // namespace naocal
