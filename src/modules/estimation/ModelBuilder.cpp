#include "estimation/ModelBuilder.hpp"

#include "effects/Catalogue.hpp"
#include "estimation/CandidateTerms.hpp"
#include "estimation/PlacementTerms.hpp"
#include "io/InputError.hpp"
#include "measurements/Measurements.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>

namespace naocal {

namespace {

/// Whether `text` matches `pattern`, where '*' stands for any run of characters.
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
  const std::string_view effect = std::string_view{wanted}.substr(0, wanted.find('@'));
  std::vector<std::string> places; // places of that effect
  std::copy_if(known.begin(), known.end(), std::back_inserter(places),
               [&](const std::string& label) { return std::string_view{label}.substr(0, label.find('@')) == effect; });
  if (places.empty()) {
    throw InputError{fmt::format("'{}' names no effect at a place of these captures; near it are {} ('naocal effects' "
                                 "lists all effects)",
                                 wanted, fmt::join(closestNames(wanted, known), ", "))};
  }
  if (wanted.find('@') == std::string::npos) {
    throw InputError{
        fmt::format("'{0}' names no place: write {0}@PLACE, such as {1}, or {0}@*", wanted, places.front())};
  }
  throw InputError{fmt::format("'{}' names no place of {} in these captures; near it are {}", wanted, effect,
                               fmt::join(closestNames(wanted, places), ", "))};
}

/// A pattern "E@P" with '*', and whether it has matched.
struct Pattern {
  std::string given;
  bool used = false;
  std::string undriven = ""; // reason, if all its matches lack their drivers

  /// A motor's effect matches under either of its joints; '*' does not match "all".
  bool names(const Term& term, const Robot& robot) const {
    const std::string motors = term.effect.placeKind == PlaceKind::motor ? labelFor(given, robot) : given;
    const bool onePlace = term.effect.placeKind == PlaceKind::board && term.placeIndex == allPlaces;
    return onePlace ? matches(motors.substr(0, motors.find('@')), term.effect.name) && motors.ends_with("@all")
                    : matches(motors, term.label());
  }
};

std::vector<Pattern> patterns(const std::vector<std::string>& given) {
  std::vector<Pattern> result;
  for (const std::string& pattern : given) {
    result.push_back({pattern});
  }
  return result;
}

/// Whether any pattern names the term.
bool anyNames(const std::vector<Pattern>& patterns, const Term& term, const Robot& robot) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const Pattern& pattern) { return pattern.names(term, robot); });
}

/// Marks matching patterns as used, or records why the term cannot be used.
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

/// Throws if a pattern names no term that can be estimated. `known`: labels of all candidates.
void refuseUnused(const std::vector<Pattern>& patterns, const std::vector<std::string>& known) {
  for (const Pattern& pattern : patterns) {
    if (!pattern.used && !pattern.undriven.empty()) {
      throw InputError{pattern.undriven};
    }
    if (!pattern.used) {
      refuse(pattern.given, known);
    }
  }
}

/// Offsets of recorded joints outside all observation chains: they move only mass, but affect the torques of others.
std::vector<Term> weighingOffsets(const Measurements& measurements) {
  std::vector<Term> result;
  for (const std::size_t motor : measurements.recordedMotors) {
    if (!std::binary_search(measurements.joints.begin(), measurements.joints.end(), motor)) {
      result.push_back({jointOffset(), motor, measurements.robot.joints[motor].name, 0, false, false});
    }
  }
  return result;
}

} // namespace

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

Model buildModel(const Measurements& measurements, const std::vector<std::string>& with,
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
    } else if (term.effect.inBaseModel || anyNames(added, term, robot)) {
      const auto undriven = untestableReason(term.effect, term.placeIndex, measurements);
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
  refuseUnused(added, known);
  refuseUnused(removed, known);
  Model model;
  for (Term& term : chosen) {
    model.add(std::move(term));
  }
  addPlacementTerms(measurements, model);
  return model;
}

} // namespace naocal
