#include "captures/InputError.hpp"
#include "effects/AllEffects.hpp"
#include "residuals/Model.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace naocal {

namespace {

/// Whether `text` fits `pattern`, where '*' stands for any run of characters.
bool matches(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) {
    return text.empty();
  }
  if (pattern.front() == '*') {
    return matches(pattern.substr(1), text) || (!text.empty() && matches(pattern, text.substr(1)));
  }
  return !text.empty() && pattern.front() == text.front() && matches(pattern.substr(1), text.substr(1));
}

/// Where an effect can sit, given what was measured: index and name.
std::vector<std::pair<std::size_t, std::string>> places(const Measurements& measurements, Place place) {
  std::vector<std::pair<std::size_t, std::string>> result;
  if (place == Place::motor) {
    for (std::size_t joint : measurements.joints) {
      result.emplace_back(joint, measurements.robot.joints[joint].name);
    }
  } else if (place == Place::camera) {
    std::set<std::size_t> cameras;
    for (const Picture& picture : measurements.pictures) {
      if (!picture.sightings.empty()) {
        cameras.insert(picture.camera);
      }
    }
    for (std::size_t camera : cameras) {
      result.emplace_back(camera, measurements.robot.cameras[camera].name);
    }
  }
  return result;
}

/// The right hip yaw-pitch has no motor of its own: its name stands for the left one's.
std::string withoutAlias(const Robot& robot, const std::string& term) {
  const std::size_t at = term.find('@');
  if (at != std::string::npos) {
    if (const auto joint = robot.jointIndex(term.substr(at + 1))) {
      return term.substr(0, at + 1) + robot.joints[robot.joints[*joint].motor].name;
    }
  }
  return term;
}

[[noreturn]] void refuse(const std::string& wanted, const std::vector<std::string>& known) {
  throw InputError{
      fmt::format("'{}' names no effect at a place of these captures; there are: {}", wanted, fmt::join(known, ", "))};
}

/// linkFromBoard or worldFromSole is off from its start by `unknowns`, named by the numbers of a placement.
Effect placementEffect(Place place, const std::vector<std::size_t>& numbers, const std::vector<double>& sigmas) {
  static const std::vector<Unknown> all{{"x", "m", 0},      {"y", "m", 0},       {"z", "m", 0},
                                        {"roll", "rad", 0}, {"pitch", "rad", 0}, {"yaw", "rad", 0}};
  Effect effect{.name = place == Place::board ? "boardPlacement" : "stancePlacement",
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
  model.add(placementEffect(Place::board, numbers, sigmas), index, target.name, true);
}

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
      model.add(placementEffect(Place::stance, {0, 1, 5}, {anywhere, anywhere, anyDirection}), standing,
                measurements.standings[standing].name, true);
    }
  }
}

} // namespace

Model makeModel(const Measurements& measurements, const std::vector<std::string>& with,
                const std::vector<std::string>& without) {
  std::vector<std::string> wanted{"jointOffset@*", "cameraRotation@*"};
  for (const std::string& term : with) {
    wanted.push_back(withoutAlias(measurements.robot, term));
  }
  std::vector<std::string> known;
  std::vector<Term> chosen;
  std::set<std::string> used;
  for (const Effect& effect : allEffects()) {
    for (const auto& [at, place] : places(measurements, effect.place)) {
      const std::string label = effect.name + "@" + place;
      known.push_back(label);
      bool take = false;
      for (const std::string& pattern : wanted) {
        if (matches(pattern, label)) {
          take = true;
          used.insert(pattern);
        }
      }
      for (const std::string& term : without) {
        const std::string pattern = withoutAlias(measurements.robot, term);
        if (matches(pattern, label)) {
          take = false;
          used.insert(pattern);
        }
      }
      if (take) {
        chosen.push_back({effect, at, place});
      }
    }
  }
  for (const auto& list : {with, without}) {
    for (const std::string& term : list) {
      if (!used.contains(withoutAlias(measurements.robot, term))) {
        refuse(term, known);
      }
    }
  }
  Model model;
  for (Term& term : chosen) {
    model.add(std::move(term.effect), term.at, std::move(term.place));
  }
  addPlacements(measurements, model);
  return model;
}

} // namespace naocal
