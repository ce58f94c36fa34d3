#include "residuals/Placements.hpp"

#include <set>

namespace naocal {

namespace {

/// linkFromBoard or worldFromSole is off from its start by `unknowns`, named by the numbers of a placement.
Effect placementEffect(Place place, const std::vector<std::size_t>& numbers, const std::vector<double>& sigmas) {
  static const std::vector<Unknown> all{{"x", "m", 0},      {"y", "m", 0},       {"z", "m", 0},
                                        {"roll", "rad", 0}, {"pitch", "rad", 0}, {"yaw", "rad", 0}};
  Effect effect{.name = place == Place::board ? "boardPlacement" : "stancePlacement",
                .what = "where it lies or stands",
                .formula = "placement = start + (x, y, z, roll, pitch, yaw)",
                .place = place,
                .unknowns = {},
                .correct = {}};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    effect.unknowns.push_back(all[numbers[i]]);
    effect.unknowns.back().sigma = sigmas[i];
  }
  effect.correct = [place, numbers](Belief& belief, const Instant&, std::size_t at, std::span<const double> values) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const auto number = static_cast<Eigen::Index>(numbers[i]);
      (place == Place::board ? belief.boardPlacement(at) : belief.ground())[number] += values[i];
    }
  };
  return effect;
}

constexpr double anywhere = 10;     // [m]: a floor placement without a guess
constexpr double anyDirection = 10; // [rad]

void addBoardPlacement(const Measurements& measurements, std::size_t index, Model& model) {
  const Target& target = measurements.targets[index];
  std::vector<std::size_t> numbers{0, 1, 5};
  std::vector<double> sigmas{anywhere, anywhere, anyDirection};
  if (!target.onFloor) {
    numbers = target.board.points.size() == 1 ? std::vector<std::size_t>{0, 1, 2}
                                              : std::vector<std::size_t>{0, 1, 2, 3, 4, 5};
    sigmas = {0.05, 0.05, 0.05, 0.3, 0.3, 0.3};
  }
  if (const auto& sigma = target.board.placementSigma) {
    const double given[6] = {sigma->x, sigma->y, sigma->z, sigma->roll, sigma->pitch, sigma->yaw};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (given[numbers[i]] > 0) {
        sigmas[i] = given[numbers[i]];
      }
    }
  }
  sigmas.resize(numbers.size());
  model.add({placementEffect(Place::board, numbers, sigmas), index, target.name, 0, true});
}

} // namespace

void addPlacements(const Measurements& measurements, Model& model) {
  std::set<std::size_t> seen, stood;
  for (const Picture& picture : measurements.pictures) {
    for (const Sighting& sighting : picture.sightings) {
      seen.insert(sighting.view.board());
      if (measurements.targets[sighting.view.board()].onFloor) {
        stood.insert(picture.stance);
      }
    }
  }
  for (std::size_t target : seen) {
    if (measurements.targets[target].unknown) {
      addBoardPlacement(measurements, target, model);
    }
  }
  for (std::size_t standing : stood) {
    if (measurements.standings[standing].unknown) {
      model.add({placementEffect(Place::stance, {0, 1, 5}, {anywhere, anywhere, anyDirection}), standing,
                 measurements.standings[standing].name, 0, true});
    }
  }
}

} // namespace naocal
