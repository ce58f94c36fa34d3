#include "captures/InputError.hpp"
#include "effects/NearNames.hpp"
#include "residuals/Candidates.hpp"

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
  throw InputError{fmt::format("'{}' names no effect at a place of these captures; near it are {}", wanted,
                               fmt::join(nearNames(wanted, known), ", "))};
}

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

} // namespace

namespace {

/// "E@P" with '*', and whether it has named anything yet.
struct Pattern {
  std::string given;
  bool used = false;
  std::string undriven = ""; // why not, where all that it names lacks its drivers

  /// A motor's effect may be named at either of its joints; '*' does not stand for "all".
  bool names(const Term& term, const Robot& robot) const {
    const std::string motors = term.effect.place == Place::motor ? withoutAlias(robot, given) : given;
    const bool onePlace = term.effect.place == Place::board && term.at == everywhere;
    return onePlace ? matches(motors.substr(0, motors.find('@')), term.effect.name) && motors.ends_with("@all")
                    : matches(motors, term.label());
  }
};

/// Whether some pattern names the term.
bool anyNames(const std::vector<Pattern>& patterns, const Term& term, const Robot& robot) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const Pattern& pattern) { return pattern.names(term, robot); });
}

/// Marks the patterns that name the term: used, or why it cannot be.
void mark(std::vector<Pattern>& patterns, const Term& term, const Robot& robot,
          const std::optional<std::string>& undriven = std::nullopt) {
  for (Pattern& pattern : patterns) {
    if (pattern.names(term, robot)) {
      pattern.used |= !undriven;
      pattern.undriven =
          undriven ? term.label() + " cannot be estimated from these captures: " + *undriven : pattern.undriven;
    }
  }
}

std::vector<Pattern> patterns(const std::vector<std::string>& given) {
  std::vector<Pattern> result;
  for (const std::string& pattern : given) {
    result.push_back({pattern});
  }
  return result;
}

bool looksAtWeight(const Term& term) {
  const auto weighs = [](Driver driver) { return driver == Driver::torque || driver == Driver::com; };
  return std::any_of(term.effect.needs.begin(), term.effect.needs.end(), weighs) ||
         std::any_of(term.effect.elsewhere.begin(), term.effect.elsewhere.end(),
                     [&](const Elsewhere& other) { return weighs(other.driver); });
}

/// The offsets of recorded joints that move nothing but mass: torques near zero depend on them.
std::vector<Term> weighingOffsets(const Measurements& measurements) {
  std::vector<Term> result;
  for (const std::size_t motor : measurements.recorded) {
    if (!std::binary_search(measurements.joints.begin(), measurements.joints.end(), motor)) {
      result.push_back({jointOffset(), motor, measurements.robot.joints[motor].name, 0, false, false});
    }
  }
  return result;
}

} // namespace

Model makeModel(const Measurements& measurements, const std::vector<std::string>& with,
                const std::vector<std::string>& without, const std::vector<Effect>& effects) {
  const std::vector<Pattern> base = patterns({"jointOffset@*", "cameraRotation@*"});
  std::vector<Pattern> added = patterns(with), removed = patterns(without);
  const Robot& robot = measurements.robot;
  std::vector<std::string> known;
  std::vector<Term> chosen;
  for (Term& term : candidateTerms(measurements, effects)) {
    known.push_back(term.label());
    if (anyNames(removed, term, robot)) {
      mark(removed, term, robot);
      mark(added, term, robot);
    } else if (anyNames(base, term, robot) || anyNames(added, term, robot)) {
      const auto undriven = whyUntestable(term.effect, term.at, measurements);
      mark(added, term, robot, undriven);
      if (!undriven) {
        chosen.push_back(std::move(term));
      }
    }
  }
  if (std::any_of(chosen.begin(), chosen.end(), looksAtWeight)) {
    for (Term& term : weighingOffsets(measurements)) {
      mark(removed, term, robot);
      if (!anyNames(removed, term, robot)) {
        chosen.push_back(std::move(term));
      }
    }
  }
  for (const std::vector<Pattern>& list : {added, removed}) {
    for (const Pattern& pattern : list) {
      if (!pattern.used && !pattern.undriven.empty()) {
        throw InputError{pattern.undriven};
      }
      if (!pattern.used) {
        refuse(pattern.given, known);
      }
    }
  }
  Model model;
  for (Term& term : chosen) {
    model.add(std::move(term));
  }
  addPlacements(measurements, model);
  return model;
}

} // namespace naocal
