#include "judge/Marks.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <cmath>
#include <cstdlib>

namespace blind {

namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool names(const Answer::Candidate& candidate, const std::string& effect) {
  return candidate.name == effect || contains(candidate.equivalent, effect);
}

const Answer::Candidate* candidateNamed(const Answer& answer, const std::string& name) {
  const auto found = std::find_if(answer.ranking.begin(), answer.ranking.end(),
                                  [&](const Answer::Candidate& candidate) { return candidate.name == name; });
  return found == answer.ranking.end() ? nullptr : &*found;
}

/// Number of candidates that the captures could test.
std::size_t testable(const Answer& answer) {
  return static_cast<std::size_t>(
      std::count_if(answer.ranking.begin(), answer.ranking.end(), [](const Answer::Candidate& candidate) {
        return candidate.state != "absorbed" && candidate.state != "no-data";
      }));
}

void markNaming(const Truth& truth, const Answer& answer, Marks& result) {
  const Truth::Effect& effect = truth.effects.front();
  const auto isIt = [&](const Answer::Candidate& candidate) { return candidate.name == effect.name; };
  const auto third = answer.ranking.begin() + std::min<std::ptrdiff_t>(3, std::ssize(answer.ranking));
  result.detected = answer.verdict == "effect-missing" || answer.verdict == "unknown-effect"; // the captures are sound
  if (truth.machine && !answer.ranking.empty()) { // precise robots show effects that matter to nobody
    const Answer::Candidate& first = answer.ranking.front();
    result.detected = *result.detected || (first.state == "trivial" && names(first, effect.name));
  }
  result.top1 = !answer.ranking.empty() && isIt(answer.ranking.front());
  result.top3 = std::any_of(answer.ranking.begin(), third, isIt);
  result.inClass = !answer.ranking.empty() && names(answer.ranking.front(), effect.name);
  result.extraNamed = std::any_of(answer.suggested.begin(), answer.suggested.end(), [&](const std::string& suggestion) {
    const Answer::Candidate* candidate = candidateNamed(answer, suggestion);
    return suggestion != effect.name && (candidate == nullptr || !names(*candidate, effect.name));
  });
  result.expected = theoreticalPower(effect.noncentrality, effect.unknowns.size(), testable(answer));
  if (const Answer::Candidate* candidate = candidateNamed(answer, effect.name)) {
    for (const auto& [name, size] : effect.unknowns) {
      const auto found = candidate->unknowns.size() == 1 ? candidate->unknowns.begin() : candidate->unknowns.find(name);
      if (found != candidate->unknowns.end() && found->second.sigma > 0) {
        result.covered.push_back(std::abs(found->second.value - size) <= 1.96 * found->second.sigma);
      }
    }
  }
}

/// Each suggestion can match one hidden effect, by name or equivalence. A certain effect with negligible influence is
/// not suggested but listed as trivial.
void markPair(const Case& one, Marks& result) {
  int found = 0;
  std::vector<std::string> left = one.answer.suggested;
  for (const Truth::Effect& effect : one.truth.effects) {
    const auto match = std::find_if(left.begin(), left.end(), [&](const std::string& suggestion) {
      const Answer::Candidate* candidate = candidateNamed(one.answer, suggestion);
      return suggestion == effect.name || (candidate != nullptr && names(*candidate, effect.name));
    });
    if (match != left.end()) {
      left.erase(match);
      ++found;
    } else if (const Answer::Candidate* told = candidateNamed(one.answer, effect.name)) {
      found += told->state == "trivial";
    }
  }
  result.bothFound = found == static_cast<int>(one.truth.effects.size());
  result.extra = static_cast<int>(left.size());
}

/// Whether two driver names are equal: "q" is the joint itself; "q:" may precede a joint.
bool sameDriver(std::string said, const std::string& at, const std::string& expected) {
  if (said.starts_with("q:")) {
    said.erase(0, 2);
  }
  const auto full = [&](const std::string& name) {
    return name == at ? std::string{"q"} : name == "time" ? "t" : name;
  };
  return full(said) == full(expected);
}

bool rightDriver(const Truth::Effect& effect, const Answer& answer) {
  if (answer.drivers.empty()) {
    return false;
  }
  const Answer::Driver& said = answer.drivers.front();
  const std::string at = effect.name.substr(effect.name.find('@') + 1);
  return said.at == at && std::any_of(effect.drivers.begin(), effect.drivers.end(),
                                      [&](const std::string& driver) { return sameDriver(said.driver, at, driver); });
}

/// Checks a result's offsets, except those dominated by their priors.
Marks::Offsets markOffsets(const Truth& truth, const std::optional<Solved>& solved) {
  constexpr double told = 0.5;
  Marks::Offsets result;
  if (!solved) {
    return result;
  }
  bool beyond = false;
  for (const auto& [joint, offset] : solved->offsets) {
    const auto known = truth.offsets.find(joint);
    if (known != truth.offsets.end() && offset.learned > told) {
      result.inside.push_back(offset.low <= known->second && known->second <= offset.high);
      beyond = beyond || known->second < offset.boundLow || offset.boundHigh < known->second;
      result.widths.push_back((offset.boundHigh - offset.boundLow) / (7 * offset.sigma));
    }
  }
  if (!result.inside.empty()) {
    result.beyond = beyond;
    result.usableBeyond = solved->usable ? std::optional{beyond} : std::nullopt;
  }
  return result;
}

/// Whether the text names the event: "board B", "stance 0" or the robot or its foot, or the joint.
bool namesEvent(const std::string& why, const Truth::Event& event) {
  const auto says = [&](const std::string& word) { return why.find(word) != why.npos; };
  if (event.what == "kicked board") {
    return says("board " + event.at);
  }
  return event.what == "slipped robot" ? says("robot") || says("stance") || says("foot") || says("slip")
                                       : says(event.at);
}

bool during(double time, const Truth::Event& event) {
  constexpr double rounding = 0.2; // of reported times [s]
  return time > event.before - rounding && time < event.after + rounding;
}

/// An event should be listed as suspicious. A joint's step may also be reported as a misfit over time, by an expression
/// such as a*(t > 12.3 ? 1 : 0).
void markEvent(const Truth::Event& event, const Answer& answer, Marks& result) {
  bool named = false, timed = false;
  for (const Answer::Suspicion& suspicion : answer.suspicious) {
    if (namesEvent(suspicion.why, event)) {
      named = true;
      timed = timed || (suspicion.time && during(*suspicion.time, event));
    }
  }
  const bool step = event.what == "offset step" && !answer.drivers.empty() && answer.verdict == "unknown-effect";
  if (step && answer.drivers.front().at == canonicalMotor("x@" + event.at).substr(2) &&
      (answer.drivers.front().driver == "t" || answer.drivers.front().driver == "time")) {
    named = true;
    const std::string& expression = answer.drivers.front().expression;
    const std::size_t after = expression.find("t > ");
    timed = timed || (after != expression.npos && during(std::strtod(expression.c_str() + after + 4, nullptr), event));
  }
  result.eventNamed = named;
  result.eventTimed = timed;
}

/// What moved beside a machine is named by its id, and when by the first capture after it.
void markMoved(const Truth::Event& event, const Answer& answer, Marks& result) {
  const auto named = [&](const Answer::Suspicion& suspicion) { return suspicion.moved == event.at; };
  result.eventNamed = std::any_of(answer.suspicious.begin(), answer.suspicious.end(), named);
  result.eventTimed =
      std::any_of(answer.suspicious.begin(), answer.suspicious.end(),
                  [&](const Answer::Suspicion& suspicion) { return named(suspicion) && suspicion.from == event.from; });
}

/// A wrong set-up stands first; a bad reading is one, and nothing else is said to be missing.
void markCulprit(const Truth& truth, const Answer& answer, Marks& result) {
  if (!truth.setUp.empty()) {
    result.culpritNamed = !answer.suspicious.empty() && answer.suspicious.front().setUp == truth.setUp;
  } else if (truth.badCapture) {
    const bool named =
        std::any_of(answer.suspicious.begin(), answer.suspicious.end(),
                    [&](const Answer::Suspicion& suspicion) { return suspicion.capture == truth.badCapture; });
    result.culpritNamed = named && answer.suggested.empty();
  }
}

/// A slipping joint may also be reported as an event with a time.
bool tellsStep(const Truth::Effect& effect, const Answer& answer) {
  const std::size_t at = effect.name.find('@');
  return effect.name.starts_with("ankleSlip@") &&
         std::any_of(answer.suspicious.begin(), answer.suspicious.end(), [&](const Answer::Suspicion& suspicion) {
           return suspicion.time && suspicion.why.find(effect.name.substr(at + 1)) != suspicion.why.npos;
         });
}

void markJitter(const Case& one, Marks& result) {
  constexpr double within = 0.2;
  result.jitterAdequate = one.answer.verdict == "adequate";
  const std::map<std::string, double> levels = one.answer.first ? one.answer.first->noise : decltype(Solved::noise){};
  const auto told = [&](const char* component) {
    const auto found = levels.find(component);
    return found == levels.end() ? 0 : found->second;
  };
  // with one reading per approach, jitter appears as scatter between approaches
  const double level = one.truth.kind == "rest" ? told("jitter") : std::hypot(told("jitter"), told("reapproach"));
  result.jitterLevel = std::abs(level - one.truth.jitter) < within * one.truth.jitter;
}

} // namespace

bool hidesOne(const Truth& truth) {
  return truth.group == "catalogue" || truth.group == "sized" || truth.group == "camera" || truth.group == "twin";
}

double theoreticalPower(double noncentrality, std::size_t unknowns, std::size_t candidates) {
  constexpr double alarms = 0.05, independentShare = 0.75;
  const double tests = std::max(1.0, independentShare * static_cast<double>(candidates));
  const double perTest = 1 - std::pow(1 - alarms, 1 / tests);
  const double critical = quantile(complement(boost::math::chi_squared(static_cast<double>(unknowns)), perTest));
  if (noncentrality <= 0) {
    return perTest;
  }
  return cdf(complement(boost::math::non_central_chi_squared(static_cast<double>(unknowns), noncentrality), critical));
}

Marks markAnswer(const Case& one) {
  const auto& [truth, answer] = one;
  Marks result;
  result.alarmed =
      answer.verdict == "effect-missing" || answer.verdict == "unknown-effect" || answer.verdict == "bad-captures";
  result.unknownSaid = answer.verdict == "unknown-effect";
  result.misfitSaid = answer.verdict == "inconclusive";
  result.given = markOffsets(truth, answer.first);
  result.added = markOffsets(truth, answer.suggestedAdded);
  if (answer.first && answer.fixedNoisePx) {
    result.rmsRatio = answer.first->rmsPx / *answer.fixedNoisePx;
  }
  if (hidesOne(truth)) {
    result.blamedOnCaptures = answer.verdict == "bad-captures" || answer.verdict == "scatter";
    markNaming(truth, answer, result);
    constexpr double plain = 20, roundedUp = 0.95; // the target size is met within 2 %
    const bool notable = truth.effects.front().noncentrality > roundedUp * plain;
    if (notable && !answer.suggested.empty()) { // a result that cannot be calibrated or compared is no improvement
      constexpr double near = 1.1;
      result.errorFell = answer.lockedAfterPx && answer.lockedFell;
      result.nearFloor = answer.lockedAfterPx && *answer.lockedAfterPx <= near * truth.lockedFloorPx;
    }
  } else if (truth.group == "pair") {
    markPair(one, result);
  } else if (truth.group == "outside") {
    result.placeAndDriver =
        (result.unknownSaid && rightDriver(truth.effects.front(), answer)) || tellsStep(truth.effects.front(), answer);
  } else if (truth.group == "absorbed") {
    const Answer::Candidate* candidate = candidateNamed(answer, truth.effects.front().name);
    result.saidUntestable = candidate != nullptr && (candidate->state == "absorbed" || candidate->state == "no-data");
  } else if (truth.group == "corrupted") {
    result.saidCorrupted = answer.verdict == "bad-captures";
  } else if (truth.machine && truth.event) {
    markMoved(*truth.event, answer, result);
  } else if (truth.group == "setup" || truth.group == "reading") {
    markCulprit(truth, answer, result);
  } else if (truth.group == "event" && truth.event) {
    markEvent(*truth.event, answer, result);
  } else if (truth.group == "jitter") {
    markJitter(one, result);
  }
  return result;
}

} // namespace blind
