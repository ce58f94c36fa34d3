#include "evaluate/ThesisScenery.hpp"

#include "captures/InputError.hpp"
#include "evaluate/ThesisStage.hpp"
#include "geometry/Index.hpp"
#include "poses/PlannedInformation.hpp"
#include "poses/PoseGenerator.hpp"
#include "poses/PoseSelection.hpp"
#include "synthetic/SimulationPlan.hpp"

#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

const double range = radians(6.5); // of offsets [rad]

/// Floor points every quarter of a metre up to 4 m away, square metres of them.
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

} // namespace

ThesisScenery thesisScenery(ThesisFeature feature) {
  ThesisScenery result{{}, drawnCameras(640, 480), {}};
  if (feature == ThesisFeature::grid) {
    result.targets = floorTiles();
    result.limits.farthest = 4.5; // from the camera, half a metre over the floor
    result.limits.grazing = radians(5);
    result.limits.corners = 1;
    return result;
  }
  result.targets = boardsAround();
  for (Board& board : result.targets) { // seen from the sole
    board.placement->y -= halfStance;
  }
  return result;
}

std::vector<Eigen::VectorXd> thesisPoses(const Robot& robot, ThesisFeature feature, std::size_t count) {
  constexpr std::size_t candidates = 300;
  const std::vector<Eigen::VectorXd> poses = candidatePoses(robot, thesisScenery(feature), candidates);
  const ThesisStage stage{robot, feature, poses, 1};
  const Model model = offsetModel(stage, range / std::sqrt(3.0));
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
  for (const std::size_t chosen : mostInformative(prior, informations, count)) {
    result.push_back(poses[usable[chosen]]);
  }
  return result;
}

} // namespace naocal
