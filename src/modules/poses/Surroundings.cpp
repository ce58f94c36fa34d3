#include "poses/Surroundings.hpp"

#include "math/Angles.hpp"

#include <cmath>
#include <map>
#include <set>

namespace naocal {

namespace {

/// A placement on the floor in the frame of another.
Placement seenFrom(const Placement& sole, const Placement& board) {
  const double x = board.x - sole.x, y = board.y - sole.y, c = std::cos(sole.yaw), s = std::sin(sole.yaw);
  Placement result;
  result.x = c * x + s * y;
  result.y = c * y - s * x;
  result.yaw = wrapped(board.yaw - sole.yaw);
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

std::vector<Surroundings> surroundings(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                                       const Model& model, const Eigen::VectorXd& unknowns) {
  const std::size_t lastSet = sets.size() - 1;
  std::map<SupportFoot, const Picture*> latest; // per foot
  std::set<std::size_t> seen;
  for (const Picture& picture : measurements.pictures) {
    const SupportFoot foot =
        picture.instant.supportFoot == SupportFoot::both ? SupportFoot::left : picture.instant.supportFoot;
    if (picture.set != lastSet || foot == SupportFoot::none) {
      continue;
    }
    const Picture*& last = latest[foot];
    last = !last || last->instant.time < picture.instant.time ? &picture : last;
    for (const Sighting& sighting : picture.sightings) {
      if (measurements.targets[sighting.view.board()].onFloor) {
        seen.insert(sighting.view.board());
      }
    }
  }
  std::vector<Surroundings> result;
  for (const auto& [foot, picture] : latest) {
    const Belief belief = believed(measurements, model, *picture, unknowns);
    Surroundings here{foot, onFloor(belief.ground()), {}};
    for (const std::size_t target : seen) {
      Board board = measurements.targets[target].board; // its id as in its set
      board.placement = seenFrom(here.sole, onFloor(belief.boardPlacement(target)));
      here.boards.push_back(std::move(board));
    }
    if (!here.boards.empty()) {
      result.push_back(std::move(here));
    }
  }
  return result;
}

} // namespace naocal
