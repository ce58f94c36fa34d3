#include "calibrate/StartingPlacements.hpp"

#include "calibrate/BoardAlignment.hpp"
#include "camera/BoardPose.hpp"
#include "math/Angles.hpp"
#include "math/LevenbergMarquardt.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

namespace naocal {

namespace {

/// A frame on the floor: x, y [m], yaw [rad] in its parent.
using OnFloor = Eigen::Vector3d;

OnFloor composed(const OnFloor& a, const OnFloor& b) {
  const double c = std::cos(a.z()), s = std::sin(a.z());
  return {a.x() + c * b.x() - s * b.y(), a.y() + s * b.x() + c * b.y(), wrapped(a.z() + b.z())};
}

OnFloor inverted(const OnFloor& a) {
  const double c = std::cos(a.z()), s = std::sin(a.z());
  return {-c * a.x() - s * a.y(), s * a.x() - c * a.y(), -a.z()};
}

/// The member nearest to all others: robust against a few wild ones.
OnFloor medoid(const std::vector<OnFloor>& all) {
  const auto distance = [](const OnFloor& a, const OnFloor& b) {
    return (a - b).head<2>().norm() + 0.5 * std::abs(wrapped(a.z() - b.z()));
  };
  double least = std::numeric_limits<double>::infinity();
  OnFloor best = all.front();
  for (const OnFloor& candidate : all) {
    const double sum = std::accumulate(all.begin(), all.end(), 0.0,
                                       [&](double s, const OnFloor& other) { return s + distance(candidate, other); });
    if (sum < least) {
      least = sum;
      best = candidate;
    }
  }
  return best;
}

/// Where a sighting puts its board in the support sole's frame: by the board's pose in the camera, or, with too few
/// corners for one, where the ray through the first corner meets the floor (unturned, at most 2 m away).
OnFloor soleFromBoard(const Measurements& measurements, const Belief& belief, const Sighting& sighting) {
  Posture torsoFromLink;
  posture(measurements.robot, belief, sighting.view.links(), torsoFromLink);
  const Attitude attitude = sighting.view.attitude(measurements.robot, belief, torsoFromLink);
  const RigidTransform soleFromOptical = attitude.opticalFromTarget.inverse();
  if (const auto opticalFromBoard = boardPose(sighting.corners, belief.lens())) {
    const RigidTransform pose = soleFromOptical * *opticalFromBoard;
    return {pose.translation.x(), pose.translation.y(), std::atan2(pose.rotation(1, 0), pose.rotation(0, 0))};
  }
  constexpr double farthest = 2; // [m]
  const CornerBlock& corner = sighting.corners.front();
  const auto lens = belief.lens();
  const Eigen::Vector3d ray = soleFromOptical.rotation *
                              Eigen::Vector3d{(corner.u[0] - lens[2]) / lens[0], (corner.v[0] - lens[3]) / lens[1], 1};
  const double down = -ray.z() / soleFromOptical.translation.z(); // 1 / (how far along the ray the floor is)
  const double reach = std::min(1 / std::max(down, 1e-9), farthest / ray.head<2>().norm());
  const Eigen::Vector3d hit = soleFromOptical.translation + reach * ray;
  return {hit.x() - corner.x[0], hit.y() - corner.y[0], 0};
}

using Placements = std::vector<std::optional<OnFloor>>;

/// Carries placements along the sightings until nothing new is reached. A group of stances and boards that touches
/// nothing known starts at its first stance.
void spread(const std::map<std::pair<std::size_t, std::size_t>, OnFloor>& seen, Placements& boards,
            Placements& stances) {
  for (bool all = false; !all;) {
    bool moved = false;
    for (const auto& [key, soleFromThatBoard] : seen) {
      auto& board = boards[key.second];
      auto& stance = stances[key.first];
      if (stance && !board) {
        board = composed(*stance, soleFromThatBoard);
        moved = true;
      } else if (board && !stance) {
        stance = composed(*board, inverted(soleFromThatBoard));
        moved = true;
      }
    }
    const auto lost =
        std::find_if(seen.begin(), seen.end(), [&](const auto& entry) { return !stances[entry.first.first]; });
    all = !moved && lost == seen.end();
    if (!moved && lost != seen.end()) {
      stances[lost->first.first] = OnFloor::Zero();
    }
  }
}

} // namespace

Eigen::VectorXd startingUnknowns(const Measurements& measurements, const Model& model,
                                 const Eigen::VectorXd& unknowns) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<OnFloor>> sightings, glimpses; // by (stance, board)
  Placements boards(measurements.targets.size()), stances(measurements.standings.size());
  std::optional<Belief> any;
  for (const Picture& picture : measurements.pictures) {
    const Belief belief = believed(measurements, model, picture, unknowns);
    any = picture.drawn;
    if (!measurements.standings[picture.stance].unknown) {
      const auto ground = picture.drawn.ground();
      stances[picture.stance] = OnFloor{ground[0], ground[1], ground[5]};
    }
    for (const Sighting& sighting : picture.sightings) {
      if (measurements.targets[sighting.view.board()].onFloor) {
        (boardPose(sighting.corners, belief.lens()) ? sightings : glimpses)[{picture.stance, sighting.view.board()}]
            .push_back(soleFromBoard(measurements, belief, sighting));
      }
    }
  }
  std::map<std::pair<std::size_t, std::size_t>, OnFloor> seen;
  sightings.merge(glimpses); // what was seen well at least once is not asked from glimpses
  for (const auto& [key, placements] : sightings) {
    seen[key] = medoid(placements);
  }
  for (std::size_t board = 0; any && board < measurements.targets.size(); ++board) {
    const Target& target = measurements.targets[board];
    if (target.onFloor && (!target.unknown || target.board.hasGuess)) {
      const auto placement = any->boardPlacement(board);
      boards[board] = OnFloor{placement[0], placement[1], placement[5]};
    }
  }
  spread(seen, boards, stances);
  Eigen::VectorXd result = unknowns;
  for (const Term& term : model.terms()) {
    if (!term.isPlacement) {
      continue;
    }
    const bool isBoard = term.effect.place == Place::board;
    if (isBoard && (!measurements.targets[term.at].onFloor || measurements.targets[term.at].board.hasGuess)) {
      continue; // starts at its guess
    }
    const auto& placement = isBoard ? boards[term.at] : stances[term.at];
    if (!placement) {
      continue;
    }
    result.segment<3>(static_cast<Eigen::Index>(term.first)) = *placement; // unknowns x, y, yaw from a start at zero
  }
  return result;
}

Eigen::VectorXd alignedUnknowns(const Measurements& measurements, const Model& model, const Eigen::VectorXd& unknowns) {
  const Eigen::VectorXd start = startingUnknowns(measurements, model, unknowns);
  const BoardAlignment alignment{measurements, model};
  if (alignment.size() == 0) {
    return start;
  }
  Eigen::VectorXd aligned =
      levenbergMarquardt(alignment, start, {.maxIterations = 30, .smallestFall = 1e-3}).value().state;
  const Eigen::VectorXd placedAnew = startingUnknowns(measurements, model, aligned);
  for (const Term& term : model.terms()) {
    if (term.isPlacement && term.effect.place == Place::board && !alignment.knows(term.at)) {
      const auto first = static_cast<Eigen::Index>(term.first),
                 count = static_cast<Eigen::Index>(term.effect.unknowns.size());
      aligned.segment(first, count) = placedAnew.segment(first, count);
    }
  }
  return aligned;
}

} // namespace naocal
