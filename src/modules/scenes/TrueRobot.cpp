#include "scenes/TrueRobot.hpp"

#include "estimation/DriverState.hpp"
#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "robot/RobotOfSet.hpp"
#include "scenes/ScenePictures.hpp"
#include "scenes/ScenePlacement.hpp"
#include "setups/Catalogue.hpp"
#include "setups/Mending.hpp"
#include "simulation/SyntheticCamera.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace naocal {

namespace {

constexpr std::size_t fewestCorners = 8; // of one board, in a pose that is kept

/// All that could be read in a pose: of each camera every corner, of trackers every marker and frame. Readings are
/// zero.
std::vector<Capture> listReadings(const CaptureSet& set) {
  std::vector<Capture> captures;
  Capture common;
  common.stance = set.stances.front().id;
  common.supportFoot = set.stances.front().supportFoot;
  for (const auto& [name, camera] : set.cameras) {
    Capture& picture = captures.emplace_back(common);
    picture.camera = name;
    picture.corners.emplace();
    for (const Board& board : set.boards) {
      BoardCorners& corners = picture.corners->emplace_back(BoardCorners{board.id, {}, {}});
      for (std::size_t id = 0; id < board.points.size(); ++id) {
        corners.ids.push_back(static_cast<int>(id));
      }
      corners.uv.assign(board.points.size(), Eigen::Vector2d::Zero());
    }
  }
  const Instruments& instruments = set.instruments;
  if (!instruments.trackers.empty()) {
    Capture& tracked = captures.emplace_back(common);
    for (const Tracker& tracker : instruments.trackers) {
      for (const TrackedMarker& marker : instruments.markers) {
        tracked.points.push_back({tracker.id, marker.id});
      }
      for (const TrackedFrame& frame : instruments.frames) {
        tracked.frames.push_back({tracker.id, frame.id});
      }
    }
  }
  return captures;
}

/// All touches that a robot can make: of every place by every marker.
std::vector<Capture> listTouches(const CaptureSet& set) {
  std::vector<Capture> captures;
  for (const TrackedMarker& marker : set.instruments.markers) {
    for (const ContactPlace& place : set.instruments.places) {
      Capture& touch = captures.emplace_back();
      touch.stance = set.stances.front().id;
      touch.supportFoot = set.stances.front().supportFoot;
      touch.contacts.push_back({marker.id, place.id});
    }
  }
  return captures;
}

/// Parts of a flaw's text.
struct Flaw {
  std::string label; // "linkGeometry@elbow"
  std::string only;  // the one unknown that is not zero; empty: all
};

Flaw parseFlaw(const std::string& text) {
  const std::string name = text.substr(0, text.find('@'));
  for (const Effect& effect : allEffects()) {
    for (const Unknown& unknown : effect.unknowns) {
      if ((effect.name == name || effect.alias == name) && text.ends_with('.' + unknown.name)) {
        return {text.substr(0, text.size() - unknown.name.size() - 1), unknown.name};
      }
    }
  }
  return {text, {}};
}

/// Whether an unknown can have one sign only: a spring is soft, a gear has play.
bool isPositive(const Effect& effect) {
  return std::any_of(effect.drivers.begin(), effect.drivers.end(), [](Driver driver) {
    return driver == Driver::torque || driver == Driver::lateral1 || driver == Driver::approach ||
           driver == Driver::com;
  });
}

BoardCorners visibleMarks(const CameraIntrinsics& camera, const Board& board,
                          const Eigen::Isometry3d& cameraFromBoard) {
  BoardCorners seen{board.id, {}, {}};
  for (std::size_t id = 0; id < board.points.size(); ++id) {
    const auto at = projectPoint(camera, cameraFromBoard * board.points[id]);
    if (at && at->x() >= 0 && at->y() >= 0 && at->x() <= camera.width - 1 && at->y() <= camera.height - 1) {
      seen.ids.push_back(static_cast<int>(id));
      seen.uv.push_back(*at);
    }
  }
  return seen;
}

} // namespace

std::string sufficientSight(const RobotScene& scene) {
  return scene.set.cameras.empty() ? "a tracker sees a marker or frame" : "a camera sees eight corners of a board";
}

TrueRobot::TrueRobot(const RobotScene& scene, const ScenePlan& plan)
    : plan_{plan}, set_{placeScene(scene, plan)}, robot_{loadRobot(set_)}, poses_{robot_, scene, plan.seed},
      readings_{listReadings(set_)}, touches_{listTouches(set_)} {
  if (readings_.empty() && touches_.empty()) {
    throw InputError{
        fmt::format("{}: expected a scene with cameras, trackers or places to touch, found neither", nameOfRobot())};
  }
  measureProbes();
  std::vector<std::string> with;
  for (const std::string& flaw : plan.flaws) {
    if (isSetUp(flaw)) {
      requireSetUp(flaw);
    } else {
      with.push_back(parseFlaw(flaw).label);
    }
  }
  for (const CameraMount& camera : robot_.cameras) {
    if (plan.mountShiftRange > 0 && !camera.inWorld) {
      with.push_back(std::string{effectName::cameraTranslation} + '@' + camera.name);
    }
  }
  model_ = buildModel(measurements_, with);
  if (plan_.images) {
    requireRenderable(set_, model_);
  }
  drawUnknowns();
  drawFlaws();
}

bool TrueRobot::isOnSole() const {
  return standsOnSole(set_);
}

/// The state of the true robot in a pose, when a picture of the template is taken.
ModelState TrueRobot::stateAt(ImageObservation& picture, const Pose& pose) const {
  const Eigen::Index joints = pose.recorded.size();
  picture.instant.q = pose.recorded;
  picture.instant.approach = pose.approach;
  picture.instant.time = pose.time;
  picture.nominal.values.head(joints) = pose.recorded;
  ModelState state = predictState(measurements_, model_, picture, unknowns_);
  state.values.head(joints) += pose.deflection;
  return state;
}

Eigen::Vector3d TrueRobot::missAt(std::size_t touch, const Pose& pose) {
  ImageObservation& picture = measurements_.pictures[templates_[readings_.size() + touch]];
  const ModelState state = stateAt(picture, pose);
  const WitnessObservation& contact = picture.witnesses.front();
  const RigidTransform linkFromWorld =
      contact.view->pathFrames({robot_, state, forwardKinematics(robot_, state)}).opticalFromWorld;
  return contact.witness->compare(linkFromWorld, state).residual.head<3>();
}

std::size_t TrueRobot::linkOfTouch(std::size_t touch) const {
  const std::string& id = touches_[touch].contacts.front().marker;
  const auto& markers = set_.instruments.markers;
  const auto marker =
      std::find_if(markers.begin(), markers.end(), [&](const TrackedMarker& one) { return one.id == id; });
  const auto link =
      std::find_if(robot_.links.begin(), robot_.links.end(), [&](const Link& one) { return one.name == marker->link; });
  return static_cast<std::size_t>(link - robot_.links.begin());
}

TrueRobot::Sight TrueRobot::look(const Pose& pose) {
  Sight sight;
  for (std::size_t i = 0; i < readings_.size(); ++i) {
    ImageObservation& picture = measurements_.pictures[templates_[i]];
    const ModelState state = stateAt(picture, pose);
    const LinkPoses torsoFromLink = forwardKinematics(robot_, state);
    Capture capture = readings_[i];
    if (picture.camera != ImageObservation::noCamera) {
      capture.corners = seeCorners(picture, state, torsoFromLink);
      sight.isEnough |= std::any_of(capture.corners->begin(), capture.corners->end(),
                                    [](const BoardCorners& seen) { return seen.ids.size() >= fewestCorners; });
    } else {
      track(picture, state, torsoFromLink, capture);
      sight.isEnough |= set_.cameras.empty() && !(capture.points.empty() && capture.frames.empty());
    }
    if (plan_.images) {
      const bool isPicture = picture.camera != ImageObservation::noCamera;
      sight.scenes.push_back(isPicture ? boardsBefore(picture, measurements_, {robot_, state, torsoFromLink})
                                       : RenderedScene{});
    }
    sight.captures.push_back(std::move(capture));
  }
  return sight;
}

Eigen::VectorXd TrueRobot::recordedAt(const Eigen::VectorXd& angles) const {
  Eigen::VectorXd recorded = angles;
  for (const std::size_t index : model_.offsets()) {
    const Term& offset = model_.terms()[index];
    for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
      if (robot_.joints[joint].motor == offset.placeIndex) {
        recorded[eigenIndex(joint)] += robot_.joints[joint].ratio * unknowns_[eigenIndex(offset.first)];
      }
    }
  }
  return recorded;
}

void TrueRobot::adoptFit(const Model& fitted, const Eigen::VectorXd& unknowns, const std::vector<Effect>& effects) {
  std::vector<std::string> with;
  for (const Term& term : fitted.terms()) {
    if (!term.isPlacement && term.requested && !term.effect.inBaseModel) {
      with.push_back(term.label());
    }
  }
  model_ = buildModel(measurements_, with, {}, effects);
  unknowns_ = mapParameters(fitted, unknowns, model_);
}

std::vector<TrueEffect> TrueRobot::listEffects() const {
  std::vector<TrueEffect> result;
  for (const Term& term : model_.terms()) {
    TrueEffect& effect = result.emplace_back(TrueEffect{term.effect.name, term.placeName, {}});
    for (std::size_t i = 0; i < term.effect.unknowns.size(); ++i) {
      const Unknown& unknown = term.effect.unknowns[i];
      effect.unknowns.push_back({unknown.name, unknowns_[eigenIndex(term.first + i)], unknown.unit});
    }
  }
  for (const std::string& flaw : plan_.flaws) {
    if (isSetUp(flaw)) {
      const std::size_t split = flaw.find('@');
      result.push_back({flaw.substr(0, split), flaw.substr(split + 1), {}});
      if (flaw.starts_with(setUpName::countSlip)) {
        result.back().unknowns.push_back({"n", 1, "1"});
      }
    }
  }
  return result;
}

/// Measurements of a few drawn poses, which say what can act and how large the loads are; the first pose's are those
/// that predict.
void TrueRobot::measureProbes() {
  constexpr std::size_t probes = 16;
  CaptureSet probed = set_;
  std::vector<Capture> readable = readings_;
  readable.insert(readable.end(), touches_.begin(), touches_.end());
  std::size_t tries = 0;
  for (std::size_t probe = 0; probe < probes; ++probe) {
    std::optional<Eigen::VectorXd> angles;
    for (; !angles && tries < probes * mostTries; ++tries) {
      angles = poses_.draw();
    }
    if (!angles) {
      throw InputError{fmt::format("{}: expected poses within the limits that keep the robot's parts apart{}, found "
                                   "none in {} draws; give `ranges` of joints in a scene",
                                   nameOfRobot(), poses_.sole() ? " and in balance" : "", tries)};
    }
    for (Capture capture : readable) {
      capture.id = static_cast<int>(probed.captures.size());
      capture.pose = fmt::format("P{}", probe);
      capture.time = Seconds{10.0 * static_cast<double>(probe)};
      capture.joints.approach.assign(set_.jointNames.size(), probe % 2 == 0 ? 1 : -1);
      for (const std::string& name : set_.jointNames) {
        capture.joints.measured.push_back((*angles)[eigenIndex(*robot_.jointIndex(name))]);
      }
      probed.captures.push_back(std::move(capture));
    }
  }
  measurements_ = buildMeasurements({std::move(probed)}, robot_);
  templates_.resize(readable.size());
  for (std::size_t picture = 0; picture < measurements_.pictures.size(); ++picture) {
    if (const std::size_t capture = measurements_.pictures[picture].capture; capture < templates_.size()) {
      templates_[capture] = picture;
    }
  }
}

std::string TrueRobot::nameOfRobot() const {
  return set_.urdf.empty() ? set_.model : (set_.folder / set_.urdf).string();
}

void TrueRobot::requireSetUp(const std::string& flaw) const {
  const std::string kind = flaw.substr(0, flaw.find('@')), joint = flaw.substr(flaw.find('@') + 1);
  if (kind != setUpName::reversedJoint && kind != setUpName::countSlip) {
    throw InputError{fmt::format("expected an effect, reversedJoint@J or countSlip@J to hide, found '{}'", flaw)};
  }
  if (std::find(set_.jointNames.begin(), set_.jointNames.end(), joint) == set_.jointNames.end()) {
    throw InputError{fmt::format("'{}' names no joint of the robot; near it are {}", flaw,
                                 fmt::join(closestNames(joint, set_.jointNames), ", "))};
  }
  if (kind == setUpName::countSlip && !set_.slipSteps.contains(joint)) {
    throw InputError{fmt::format("'{}' needs the motor's turn at the joint: expected slipSteps.{} in the scene, found "
                                 "none",
                                 flaw, joint)};
  }
}

/// The largest load of a joint in the probed poses, about its axis (0) or, of a robot with a URDF, its normals (1, 2)
/// [Nm].
double TrueRobot::largestLoad(std::size_t joint, std::size_t about) const {
  double largest = 0;
  for (const PoseGroup& pose : measurements_.poses) {
    const ImageObservation& picture = measurements_.pictures[pose.readings.front().pictures.front()];
    const RobotSample sample = sampleAt(measurements_, Model{}, picture, {});
    const double load =
        about == 0 ? sample.torque[eigenIndex(joint)] : sample.lateralTorque(eigenIndex(about - 1), eigenIndex(joint));
    largest = std::max(largest, std::abs(load));
  }
  return largest;
}

/// Plausible size of an unknown of a term: its sigma, but no spring gives way by more than 0.02 rad.
double TrueRobot::plausibleSize(const Term& term, std::size_t unknown) const {
  constexpr double largestYield = 0.02; // [rad]
  const double size = term.effect.unknowns[unknown].sigma;
  if (term.effect.unknowns[unknown].unit != "rad/Nm") {
    return size;
  }
  const bool isLateral = term.effect.drivers.front() == Driver::lateral1;
  const double load = largestLoad(term.placeIndex, isLateral ? unknown + 1 : 0);
  return load > 0 ? std::min(size, largestYield / load) : size;
}

void TrueRobot::drawUnknowns() {
  RandomStream chance{plan_.robotSeed.value_or(plan_.seed), "errors"};
  unknowns_ = Eigen::VectorXd::Zero(eigenIndex(model_.unknownCount()));
  for (const Term& term : model_.terms()) {
    const std::string& name = term.effect.name;
    for (std::size_t i = 0; i < term.effect.unknowns.size(); ++i) {
      double& value = unknowns_[eigenIndex(term.first + i)];
      if (name == effectName::jointOffset) {
        value = chance.uniformWithin(plan_.offsetRange);
      } else if (name == effectName::cameraRotation) {
        value = chance.uniformWithin(plan_.mountRange);
      } else if (name == effectName::cameraTranslation) {
        value = plan_.mountShiftRange > 0 ? chance.uniformWithin(plan_.mountShiftRange)
                                          : plan_.spread * chance.normal(term.effect.unknowns[i].sigma);
      }
    }
  }
}

void TrueRobot::drawFlaws() {
  RandomStream chance{plan_.robotSeed.value_or(plan_.seed), "flaw"};
  for (const std::string& text : plan_.flaws) {
    const Flaw flaw = parseFlaw(text);
    const Term* const term = isSetUp(text) ? nullptr : model_.find(labelFor(flaw.label, robot_));
    for (std::size_t i = 0; term && i < term->effect.unknowns.size(); ++i) {
      const double sign = isPositive(term->effect) || !chance.bernoulli(0.5) ? 1 : -1;
      if (flaw.only.empty() || flaw.only == term->effect.unknowns[i].name) {
        unknowns_[eigenIndex(term->first + i)] = sign * plan_.flawScale * plausibleSize(*term, i);
      }
    }
  }
}

std::map<std::string, CameraIntrinsics> TrueRobot::lenses() const {
  std::map<std::string, CameraIntrinsics> lenses;
  for (const ImageObservation& picture : measurements_.pictures) {
    if (picture.camera != ImageObservation::noCamera) {
      const std::string& name = robot_.cameras[picture.camera].name;
      lenses.emplace(name, lensIn(predictState(measurements_, model_, picture, unknowns_), set_.cameras.at(name)));
    }
  }
  return lenses;
}

std::vector<BoardCorners> TrueRobot::seeCorners(const ImageObservation& picture, const ModelState& state,
                                                const LinkPoses& torsoFromLink) const {
  const Eigen::Matrix3d cameraFromOptical = opticalFromCamera().transpose();
  const CameraIntrinsics camera = lensIn(state, set_.cameras.at(robot_.cameras[picture.camera].name));
  std::vector<BoardCorners> seen;
  for (const BoardObservation& observation : picture.observations) {
    const Board& board = measurements_.targets[observation.view.board()].board;
    const CameraFrames frames = observation.view.cameraFrames({robot_, state, torsoFromLink});
    Eigen::Isometry3d cameraFromBoard = Eigen::Isometry3d::Identity();
    cameraFromBoard.linear() = cameraFromOptical * frames.opticalFromBoard.rotation;
    cameraFromBoard.translation() = cameraFromOptical * frames.opticalFromBoard.translation;
    BoardCorners corners =
        board.pattern ? visibleCorners(camera, board, cameraFromBoard) : visibleMarks(camera, board, cameraFromBoard);
    ProjectedBlocks projected;
    if (corners.ids.empty() || !observation.view.project(frames, state, packCorners(board, corners), projected)) {
      continue;
    }
    for (std::size_t i = 0; i < corners.ids.size(); ++i) {
      const auto lane = eigenIndex(i % 4);
      corners.uv[i] = {projected[i / 4].u[lane], projected[i / 4].v[lane]};
    }
    seen.push_back(std::move(corners));
  }
  return seen;
}

/// Whether none of the robot's shapes is between a tracker and a point; those that hold the point are not.
bool TrueRobot::isInSight(const Eigen::Vector3d& trackerInTorso, const Eigen::Vector3d& pointInTorso,
                          const LinkPoses& torsoFromLink) const {
  return std::none_of(robot_.collisionCapsules.begin(), robot_.collisionCapsules.end(), [&](const Capsule& part) {
    const Eigen::Vector3d from = torsoFromLink[part.link] * part.from, to = torsoFromLink[part.link] * part.to;
    return segmentDistance(pointInTorso, pointInTorso, from, to) > part.radius &&
           segmentDistance(trackerInTorso, pointInTorso, from, to) < part.radius;
  });
}

/// Keeps the readings of what is in sight, as predicted: the witnesses of the template compare with zero, so that
/// their residuals are the predictions, first of the points, then of the frames.
void TrueRobot::track(const ImageObservation& picture, const ModelState& state, const LinkPoses& torsoFromLink,
                      Capture& capture) const {
  const std::size_t support = measurements_.stances[picture.stance].supportLink.value();
  const RigidTransform torsoFromWorld =
      torsoFromLink[support] * transformFromPlacement(state.worldFromSupport()).inverse();
  std::vector<PointReading> points;
  std::vector<FrameReading> frames;
  for (std::size_t i = 0; i < picture.witnesses.size(); ++i) {
    const WitnessObservation& observation = picture.witnesses[i];
    const WitnessRows rows = observation.witness->compare(
        observation.view->pathFrames({robot_, state, torsoFromLink}).opticalFromWorld, state);
    const Eigen::Vector3d xyz = rows.residual.head<3>();
    const bool isPoint = i < capture.points.size();
    const std::string& tracker =
        isPoint ? capture.points[i].tracker : capture.frames[i - capture.points.size()].tracker;
    const RigidTransform torsoFromTracker =
        torsoFromWorld * transformFromPlacement(findTracker(set_, tracker).placement->numbers());
    if (!isInSight(torsoFromTracker.translation, torsoFromTracker * xyz, torsoFromLink)) {
      continue;
    }
    if (isPoint) {
      points.push_back({tracker, capture.points[i].marker, xyz});
    } else {
      const Eigen::Vector3d turn = rows.residual.tail<3>();
      frames.push_back(
          {tracker, capture.frames[i - capture.points.size()].frame, xyz, Eigen::Quaterniond{rotationAbout(turn)}});
    }
  }
  capture.points = std::move(points);
  capture.frames = std::move(frames);
}

} // namespace naocal
