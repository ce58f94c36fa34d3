#include "evaluation/ThesisExperiment.hpp"

#include "estimation/ModelBuilder.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/SubsetSelection.hpp"
#include "poses/candidates/BoardPlacement.hpp"
#include "poses/candidates/PoseSampler.hpp"
#include "poses/criteria/PlannedInformation.hpp"
#include "poses/criteria/ThesisCriterion.hpp"
#include "robot/Balance.hpp"
#include "simulation/SimulationPlan.hpp"
#include "simulation/SyntheticCamera.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace naocal {

namespace {

/// Noise before rounding, 1 sigma [rad].
double angleSigma(AngleNoise noise) {
  return noise == AngleNoise::radians     ? 0.007
         : noise == AngleNoise::degrees   ? radians(0.007)
         : noise == AngleNoise::unrounded ? programAngleNoise
                                          : 0;
}

/// Deflection of a sticking gear behind the encoder, 1 sigma: half a motor's dead zone [rad].
const double stiction = radians(0.05);

bool isDithered(const ThesisSetting& setting) {
  return setting.jointNoise == AngleNoise::encoder || setting.jointNoise == AngleNoise::stiction;
}

const double range = radians(6.5); // range of the offsets [rad]

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
      offset = chance.uniformWithin(range);
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

/// Floor points every 0.25 m up to 4 m away, in tiles of one square metre.
std::vector<Board> floorTiles() {
  constexpr int perMetre = 4, farthest = 4;
  std::vector<Board> tiles;
  for (int x = 0; x < farthest; ++x) {
    for (int y = -farthest; y < farthest; ++y) {
      Board tile;
      tile.id = fmt::format("{}{:+}", x, y);
      tile.placement = Placement{static_cast<double>(x), static_cast<double>(y)};
      for (int i = 0; i < perMetre * perMetre; ++i) {
        const Eigen::Vector3d point{(i % perMetre + 0.5) / perMetre, (i / perMetre + 0.5) / perMetre, 0};
        if (Eigen::Vector2d{x + point.x(), y + point.y()}.norm() <= farthest) {
          tile.points.push_back(point);
        }
      }
      if (!tile.points.empty()) {
        tiles.push_back(tile);
      }
    }
  }
  return tiles;
}

/// Finds the visible corners of a target and their positions; none if fewer than the limit are visible.
void findSeen(const Board& target, const CameraFrames& attitude, const ProjectedBlocks& projected,
              const CameraIntrinsics& lens, const VisibilityLimits& limits, BoardCorners& seen) {
  const double height = attitude.opticalFromBoard.inverse().translation.z(); // of the camera above the floor
  seen.ids.clear();
  seen.uv.clear();
  for (std::size_t i = 0; i < target.points.size(); ++i) {
    const double u = projected[i / 4].u[i % 4], v = projected[i / 4].v[i % 4];
    if (u < limits.border || u > lens.width - 1 - limits.border || v < limits.border ||
        v > lens.height - 1 - limits.border) {
      continue;
    }
    const double distance = (attitude.opticalFromBoard * target.points[i]).norm();
    if (distance >= limits.nearest && distance <= limits.farthest && height >= distance * std::sin(limits.grazing)) {
      seen.ids.push_back(static_cast<int>(i));
      seen.uv.emplace_back(u, v);
    }
  }
  if (seen.ids.size() < limits.corners) {
    seen.ids.clear();
  }
}

/// A pattern of floor points as a target.
Board asTarget(const FloorPattern& pattern, std::string id) {
  Board target;
  target.id = std::move(id);
  target.placement = Placement{pattern.x, pattern.y, 0, 0, 0, pattern.yaw};
  const Eigen::Matrix2Xd points = pattern.points();
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    target.points.emplace_back(points(0, i), points(1, i), 0);
  }
  return target;
}

/// A target's points in the left sole's frame [m].
Eigen::Matrix2Xd pointsOnFloor(const Board& target) {
  Eigen::Matrix2Xd points(2, eigenIndex(target.points.size()));
  for (std::size_t i = 0; i < target.points.size(); ++i) {
    points.col(eigenIndex(i)) = (isometryFromPlacement(target.placement.value()) * target.points[i]).head<2>();
  }
  return points;
}

/// Floor points as the thesis's program sees them: by the bottom camera, if the picture passes the horizon test, and
/// wherever they lie in the image.
ThesisScene makeProgramScene(const std::vector<FloorPattern>& patterns) {
  ThesisScene result{{}, {{"bottom", nominalCameras(640, 480).at("bottom")}}, {}, true};
  for (const FloorPattern& pattern : patterns) {
    result.targets.push_back(asTarget(pattern, fmt::format("pattern {}", result.targets.size() + 1)));
  }
  result.limits.nearest = 0;
  result.limits.farthest = 100;
  result.limits.grazing = 0;
  result.limits.border = 0;
  result.limits.corners = 1;
  return result;
}

/// Boards: the four A2 boards of simulated sets. Grid: points every 0.25 m up to 4 m away, in tiles of one square metre
/// with known correspondence; single points of a tile are visible too.
ThesisScene makeThesisScene(ThesisFeature feature, const std::vector<FloorPattern>& patterns) {
  if (feature == ThesisFeature::file) {
    return makeProgramScene(patterns);
  }
  if (feature == ThesisFeature::programGrid) {
    return makeProgramScene({programGrid()});
  }
  if (feature == ThesisFeature::fourBoards || feature == ThesisFeature::eightBoards) {
    return makeProgramScene({programBoard()});
  }
  ThesisScene result{{}, nominalCameras(640, 480), {}};
  if (feature == ThesisFeature::grid) {
    result.targets = floorTiles();
    result.limits.farthest = 4.5; // [m] from the camera, which is 0.5 m above the floor
    result.limits.grazing = radians(5);
    result.limits.corners = 1;
    return result;
  }
  result.targets = defaultBoards();
  for (Board& board : result.targets) { // relative to the sole
    board.placement->y -= halfFootDistance;
  }
  return result;
}

void addNoise(ImageObservation& picture, double pixel, RandomStream& chance) {
  for (BoardObservation& observation : picture.observations) {
    for (CornerBlock& block : observation.corners) {
      for (int i = 0; i < 4; ++i) {
        block.u[i] += chance.normal(pixel);
        block.v[i] += chance.normal(pixel);
      }
    }
  }
}

/// Measurements of all targets in all poses: one image per camera and sample, containing every corner.
Measurements observeEverything(const Robot& robot, const ThesisScene& scenery, const ThesisSetting& setting,
                               const std::vector<ThesisPose>& poses) {
  CaptureSet set{.name = "thesis", .model = robot.model, .cameras = scenery.cameras, .boards = scenery.targets};
  set.stances = {{0, SupportFoot::left, Placement{}}, {1, SupportFoot::right, Placement{.y = -footDistance}}};
  for (Board& board : set.boards) {
    if (setting.unknownPlaces) {
      board.placementGuess = *board.placement;
      board.hasGuess = true;
      board.placement.reset();
    }
  }
  for (const Joint& joint : robot.joints) {
    set.jointNames.push_back(joint.name);
  }
  std::vector<BoardCorners> all;
  for (const Board& board : scenery.targets) {
    BoardCorners& corners = all.emplace_back(BoardCorners{board.id, std::vector<int>(board.points.size()), {}});
    std::iota(corners.ids.begin(), corners.ids.end(), 0);
    corners.uv.assign(board.points.size(), Eigen::Vector2d::Zero());
  }
  for (std::size_t pose = 0; pose < poses.size(); ++pose) {
    for (std::size_t sample = 0; sample < setting.samples; ++sample) {
      for (const auto& [camera, lens] : scenery.cameras) {
        Capture& capture = set.captures.emplace_back();
        capture.id = static_cast<int>(set.captures.size());
        capture.pose = fmt::format("P{:04}", pose);
        capture.repeat = static_cast<int>(sample);
        capture.repeatKind = RepeatKind::reapproach; // new reading errors for each sample
        capture.camera = camera;
        capture.supportFoot = poses[pose].foot;
        capture.stance = poses[pose].foot == SupportFoot::left ? 0 : 1;
        capture.joints.measured.assign(poses[pose].angles.begin(), poses[pose].angles.end());
        capture.corners = all;
      }
    }
  }
  return buildMeasurements({set}, robot);
}

} // namespace

double cornerNoise(const ThesisSetting& setting, double pixel) {
  return pixel / std::sqrt(static_cast<double>(copiesOf(setting.feature)));
}

Noise thesisNoise(const ThesisSetting& setting, double pixel) {
  const double noPixelNoise = setting.angleNoise() ? 0.03 : 0.01; // [px]
  const double rounding =
      setting.likeProgram() ? 0 : encoderStep / std::sqrt(isDithered(setting) ? 6.0 : 12.0); // one uniform error, or
                                                                                             // the sum of two
  const double sharing = setting.likeProgram() ? static_cast<double>(setting.samples) : 1;
  return {.pixel = setting.pixelNoise() ? cornerNoise(setting, pixel) * std::sqrt(sharing) : noPixelNoise,
          .encoder = setting.angleNoise() ? std::hypot(angleSigma(setting.jointNoise), rounding) : 0,
          .pose = setting.angleNoise() && setting.jointNoise == AngleNoise::stiction ? stiction : 0};
}

AngleReading readAngle(double commanded, const ThesisSetting& setting, RandomStream& chance) {
  if (!setting.angleNoise()) {
    return {commanded, commanded};
  }
  if (setting.likeProgram()) {
    return {commanded + chance.normal(programAngleNoise), commanded};
  }
  const double raw = commanded + chance.uniformWithin(encoderStep / 2);
  const double noise =
      isDithered(setting) ? chance.uniformWithin(encoderStep / 2) : chance.normal(angleSigma(setting.jointNoise));
  const double behind = setting.jointNoise == AngleNoise::stiction ? chance.normal(stiction) : 0;
  return {raw + behind, encoderStep * std::round((raw + noise) / encoderStep)};
}

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

std::size_t copiesOf(ThesisFeature feature) {
  return feature == ThesisFeature::fourBoards ? 4 : feature == ThesisFeature::eightBoards ? 8 : 1;
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
  const Model model = makeExperimentModel(stage, range / std::sqrt(3.0), 0);
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

ThesisExperiment::ThesisExperiment(const Robot& robot, const ThesisSetting& setting,
                                   const std::vector<ThesisPose>& poses, const ThesisInputs& inputs)
    : inputs_{inputs}, scenery_{makeThesisScene(setting.feature, inputs.features)},
      everything_{observeEverything(robot, scenery_, setting, poses)} {
  std::vector<Effect> effects{jointOffset()};
  if (setting.unknownPlaces) {
    effects.push_back(cameraRotation());
  }
  model_ = buildModel(everything_, {}, {}, effects);
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const auto motor = std::find(joints().begin(), joints().end(), robot.joints[joint].motor);
    if (motor != joints().end()) {
      driven_.emplace_back(joint, motor - joints().begin());
    }
  }
  if (scenery_.hasHorizonTest) {
    tested_ = bottomCamera<double>();
    for (const Target& target : everything_.targets) {
      targetPoints_.push_back(pointsOnFloor(target.board));
    }
  }
}

template <typename Scalar> SoleCamera<Scalar> ThesisExperiment::bottomCamera() const {
  const Robot& robot = everything_.robot;
  return {robot, robot.cameraIndex("bottom").value(), robot.findSole("left")->link, joints(),
          scenery_.cameras.at("bottom")};
}

template SoleCamera<float> ThesisExperiment::bottomCamera() const;
template SoleCamera<double> ThesisExperiment::bottomCamera() const;

Eigen::Vector2d ThesisExperiment::floorPoint(const BoardObservation& observation, std::size_t corner) const {
  return targetPoints_[observation.view.board()].col(eigenIndex(corner));
}

Eigen::Matrix2Xd ThesisExperiment::floorPoints() const {
  Eigen::Matrix2Xd all(2, 0);
  for (const Eigen::Matrix2Xd& points : targetPoints_) {
    all.conservativeResize(2, all.cols() + points.cols());
    all.rightCols(points.cols()) = points;
  }
  return all;
}

std::vector<std::array<Eigen::Vector2d, 4>> ThesisExperiment::fieldsOfView() const {
  const SoleCamera<double> camera = bottomCamera<double>();
  std::vector<std::array<Eigen::Vector2d, 4>> result;
  for (const PoseGroup& pose : everything_.poses) {
    const ModelState& nominal = everything_.pictures[pose.readings.front().pictures.front()].nominal;
    Eigen::VectorXd angles(eigenIndex(joints().size()));
    for (std::size_t i = 0; i < joints().size(); ++i) {
      angles[eigenIndex(i)] = nominal.angle(joints()[i]);
    }
    if (const auto view = fieldOfView(camera, camera.cameraFromSole(angles), programReach)) {
      result.push_back(*view);
    }
  }
  return result;
}

std::vector<std::string> ThesisExperiment::jointNames() const {
  std::vector<std::string> names;
  for (const std::size_t joint : joints()) {
    names.push_back(everything_.robot.joints[joint].name);
  }
  return names;
}

/// The same as the thesis's program sees: if the picture passes the horizon test, all points that lie in it.
void ThesisExperiment::lookAsProgram(const ImageObservation& all, const Eigen::VectorXd& angles,
                                     ImageObservation& seen) const {
  thread_local BoardCorners corners;
  thread_local Eigen::Matrix2Xd pixels;
  seen.observations.clear();
  const auto cameraFromSole = tested_->cameraFromSole(angles);
  if (!passesHorizonTest(*tested_, cameraFromSole)) {
    return;
  }
  for (const BoardObservation& observation : all.observations) {
    const Board& target = everything_.targets[observation.view.board()].board;
    tested_->project(cameraFromSole, targetPoints_[observation.view.board()], pixels);
    corners.ids.clear();
    corners.uv.clear();
    for (Eigen::Index i = 0; i < pixels.cols(); ++i) {
      if (isInImage(tested_->lens(), pixels.col(i))) {
        corners.ids.push_back(static_cast<int>(i));
        corners.uv.emplace_back(pixels.col(i));
      }
    }
    if (!corners.ids.empty()) {
      seen.observations.push_back({observation.view, packCorners(target, corners), corners.ids});
    }
  }
}

/// Fills `seen` with the visible corners when the experiment's joints have these true angles.
void ThesisExperiment::look(const ImageObservation& all, const Eigen::VectorXd& angles, const Eigen::VectorXd& truth,
                            ImageObservation& seen) const {
  thread_local LinkPoses torsoFromLink;
  thread_local ProjectedBlocks projected;
  thread_local BoardCorners corners;
  if (tested_) {
    lookAsProgram(all, angles, seen);
    return;
  }
  const Robot& robot = everything_.robot;
  ModelState real = all.nominal;
  for (const auto& [joint, i] : driven_) {
    real.angle(joint) = angles[i];
  }
  for (std::size_t term = joints().size(); term < model_.terms().size(); ++term) { // mounts and places
    const Term& other = model_.terms()[term];
    for (const CorrectedPlace& place : placesOn(other, everything_, all)) {
      place.correct(real, other.effect, all.instant, other.values(truth));
    }
  }
  forwardKinematics(robot, real, all.observations.front().view.links(), torsoFromLink);
  CameraFrames attitude = all.observations.front().view.pathFrames({robot, real, torsoFromLink});
  const CameraIntrinsics& lens = scenery_.cameras.at(robot.cameras[all.camera].name);
  seen.observations.clear();
  for (const BoardObservation& observation : all.observations) {
    observation.view.placeBoard(transformFromPlacement(real.boardPlacement(observation.view.board())), attitude);
    if (!observation.view.project(attitude, real, observation.corners, projected)) {
      continue;
    }
    const Board& target = everything_.targets[observation.view.board()].board;
    findSeen(target, attitude, projected, lens, scenery_.limits, corners);
    if (!corners.ids.empty()) {
      seen.observations.push_back({observation.view, packCorners(target, corners), corners.ids});
    }
  }
}

void ThesisExperiment::simulate(const Eigen::VectorXd& truth, const std::function<AngleReading(double)>& read,
                                double pixel, RandomStream& chance, Measurements& taken) const {
  Eigen::VectorXd angles{eigenIndex(joints().size())}, reported = angles;
  for (const PoseGroup& pose : everything_.poses) {
    for (const EncoderSample& each : pose.readings) {
      const ModelState& commanded = everything_.pictures[each.pictures.front()].nominal;
      for (std::size_t i = 0; i < joints().size(); ++i) {
        const AngleReading reading = read(commanded.angle(joints()[i]));
        angles[eigenIndex(i)] = reading.raw - truth[eigenIndex(i)];
        reported[eigenIndex(i)] = reading.reported;
      }
      for (const std::size_t index : each.pictures) {
        ImageObservation& picture = taken.pictures[index];
        for (const auto& [joint, i] : driven_) {
          picture.nominal.angle(joint) = picture.instant.q[eigenIndex(joint)] = reported[i];
        }
        look(everything_.pictures[index], angles, truth, picture);
      }
    }
  }
  if (pixel > 0) {
    addCornerNoise(pixel, chance, taken);
  }
}

void ThesisExperiment::addCornerNoise(double pixel, RandomStream& chance, Measurements& taken) const {
  for (const PoseGroup& pose : everything_.poses) {
    const RandomStream first = chance;
    for (const EncoderSample& sample : pose.readings) {
      if (tested_) { // the program's samples differ by joint noise only
        chance = first;
      }
      for (const std::size_t index : sample.pictures) {
        addNoise(taken.pictures[index], pixel, chance);
      }
    }
  }
}

Model makeExperimentModel(const ThesisExperiment& stage, double offsetSigma, double mountSigma) {
  Model result;
  for (Term term : stage.model().terms()) {
    for (Unknown& unknown : term.effect.unknowns) {
      if (!term.isPlacement) {
        unknown.sigma = term.effect.placeKind == PlaceKind::camera ? mountSigma : offsetSigma;
      }
    }
    result.add(std::move(term));
  }
  return result;
}

} // namespace naocal
