#include "io/InputError.hpp"
#include "residuals/Candidates.hpp"
#include "residuals/Placements.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

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

[[noreturn]] void refuse(const std::string& wanted, const std::vector<std::string>& known) {
  throw InputError{fmt::format("'{}' names no effect at a place of these captures; near it are {}", wanted,
                               fmt::join(nearNames(wanted, known), ", "))};
}

/// "E@P" with '*', and whether it has named anything yet.
struct Pattern {
  std::string given;
  bool used = false;
  std::string undriven = ""; // why not, where all that it names lacks its drivers

  /// A motor's effect may be named at either of its joints; '*' does not stand for "all".
  bool names(const Term& term, const Robot& robot) const {
    const std::string motors = term.effect.place == Place::motor ? labelFor(given, robot) : given;
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

std::string labelFor(const std::string& given, const Robot& robot) {
  const std::size_t split = std::min(given.find('@'), given.size());
  std::string effect = given.substr(0, split), place = given.substr(split);
  for (const Effect& known : allEffects()) {
    effect = !known.alias.empty() && known.alias == effect ? known.name : effect;
  }
  if (const auto joint = place.empty() ? std::nullopt : robot.jointIndex(place.substr(1))) {
    place = '@' + robot.joints[robot.joints[*joint].motor].name;
  }
  return effect + place;
}

Model withWeighingOffsets(const Measurements& measurements, Model model, const std::vector<Term>& further) {
  const auto& terms = model.terms();
  if (std::any_of(terms.begin(), terms.end(), looksAtWeight) ||
      std::none_of(further.begin(), further.end(), looksAtWeight)) {
    return model;
  }
  for (Term& term : weighingOffsets(measurements)) {
    const bool there =
        std::any_of(terms.begin(), terms.end(), [&](const Term& own) { return own.label() == term.label(); });
    if (!there) {
      model.add(std::move(term));
    }
  }
  return model;
}

Model makeModel(const Measurements& measurements, const std::vector<std::string>& with,
                const std::vector<std::string>& without, const std::vector<Effect>& effects) {
  std::vector<Pattern> added = patterns(with), removed = patterns(without);
  const Robot& robot = measurements.robot;
  std::vector<std::string> known;
  std::vector<Term> chosen;
  for (Term& term : candidateTerms(measurements, effects)) {
    known.push_back(term.label());
    if (anyNames(removed, term, robot)) {
      mark(removed, term, robot);
      mark(added, term, robot);
    } else if (term.effect.base || anyNames(added, term, robot)) {
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
