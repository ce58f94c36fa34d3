#include "report/DiagnosisFacts.hpp"

#include "math/Angles.hpp"
#include "report/PageValues.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

namespace {

constexpr Range probability{0, 1, ""};
constexpr Range pixels{0, 1e9, "px"};

/// Joint scatter from pose to pose in the last model, 1 sigma [rad].
double scatterOf(const JsonCursor& diagnosis) {
  return diagnosis.at("poseScatter").number({0, 10, "rad"});
}

std::string chance(double p) {
  return p < 0.001 ? "p < 0.001" : fmt::format("p = {:.2g}", p);
}

Fact heldOutFact(const std::vector<JsonCursor>& all, const std::string& floor, const ErrorUnit& errors) {
  const std::string noise =
      fmt::format("{}: {}", floor, formatError(all.back().at("noiseFloorPx").number(pixels), errors));
  if (all.front().at("heldOutPx").value().is_null()) {
    return {formatError(all.front().at("rmsPx").number(pixels), errors),
            "error of the fit (of one pose: none is left to hold out); " + noise + "."};
  }
  const std::string before = formatError(all.front().at("heldOutPx").number(pixels), errors),
                    after = formatError(all.back().at("heldOutPx").number(pixels), errors);
  if (all.size() == 1) {
    return {before, "held-out error: on poses that the fit has not seen; " + noise + "."};
  }
  return {fmt::format("{} → {}", before.substr(0, before.find(' ')), after),
          "held-out error: on poses that neither the fit nor the choice of effects has seen, before and after adding "
          "what is suggested; " +
              noise + "."};
}

/// How sure the first suggested effect is, and what comes next by itself; absent without one.
std::optional<Fact> evidenceFact(const JsonCursor& diagnosis) {
  const std::vector<std::string> suggested = diagnosis.at("suggested").texts();
  double own = 0, next = 0;
  int step = 0; // only candidates for the same model compare
  std::string other;
  std::vector<std::string> alike = suggested;
  for (const JsonCursor& entry : diagnosis.at("ranking").elements()) {
    const std::string name = entry.at("effect").text() + "@" + entry.at("at").text();
    const auto told = entry.find("evidence");
    if (!told || told->value().is_null()) {
      continue;
    }
    const double evidence = told->number({-1e15, 1e15, ""});
    if (!suggested.empty() && name == suggested.front()) {
      own = evidence;
      step = entry.at("step").integer(0, maxInteger);
      const std::vector<std::string> equivalent = entry.at("equivalent").texts();
      alike.insert(alike.end(), equivalent.begin(), equivalent.end());
    } else if (evidence > next && entry.at("step").integer(0, maxInteger) == step &&
               std::find(alike.begin(), alike.end(), name) == alike.end()) {
      next = evidence;
      other = name;
    }
  }
  if (own <= 0) {
    return std::nullopt;
  }
  return Fact{
      fmt::format("{:.0f}", own),
      fmt::format(
          "is the evidence for {}, 2 ln of the Bayes factor (above 10: very strong){}.", suggested.front(),
          other.empty() || next >= own ? "" : fmt::format("; the next likeliest, {}, would have {:.0f}", other, next))};
}

/// `found`: the verdict is something other than a candidate, found by its own test.
Fact alarmFact(double alarm, bool found) {
  if (alarm <= 0.05) {
    return {chance(alarm), "is the chance that noise alone looks this convincing."};
  }
  return {chance(alarm), std::string{"is the chance that noise alone looks this convincing: "} +
                             (found ? "no reason to add a candidate. The finding above rests on a test of its own."
                                    : "no reason to add anything.")};
}

Fact lackOfFitFact(const JsonCursor& lackOfFit) {
  return {fmt::format("{:.2f}", lackOfFit.at("statistic").number({0, 1e15, ""})),
          "is the lack of fit of the first model, chi² per degree of freedom; noise alone gives 1."};
}

} // namespace

const std::vector<std::string_view>& verdicts() {
  static const std::vector<std::string_view> all{"adequate", "effect-missing", "unknown-effect",
                                                 "scatter",  "inconclusive",   "bad-captures"};
  return all;
}

bool isTentative(const JsonCursor& diagnosis) {
  const auto tentative = diagnosis.find("tentative"); // absent in files of earlier versions
  return tentative && tentative->boolean();
}

std::string verdictLevel(const JsonCursor& diagnosis) {
  const auto findings = diagnosis.find("findings");
  return findings && !findings->elements().empty() ? findings->elements().front().at("level").text() : "";
}

std::string verdictHeadline(const JsonCursor& diagnosis) {
  static const std::vector<std::string> headlines{"The model explains these captures.",
                                                  "An effect is missing in the model.",
                                                  "Something that no known effect explains is at work.",
                                                  "Joints scatter at random.",
                                                  "Undecided: the model does not fit, but no single cause stands out.",
                                                  "Something is wrong with the captures or the set-up."};
  return isTentative(diagnosis) ? "An effect may be missing in the model."
                                : headlines[diagnosis.at("verdict").wordIndex(verdicts())];
}

std::string noiseFloorName(const JsonCursor& diagnosis) {
  return scatterOf(diagnosis) > 0 ? "noise floor with joint scatter" : "noise floor";
}

std::vector<Fact> diagnosisFacts(const JsonCursor& diagnosis, const ErrorUnit& errors) {
  const std::vector<JsonCursor> steps = diagnosis.at("steps").elements();
  if (steps.empty()) { // no fit was possible
    return {};
  }
  const double scatter = scatterOf(diagnosis);
  const std::string verdict = diagnosis.at("verdict").text();
  std::vector<Fact> facts{heldOutFact(steps, noiseFloorName(diagnosis), errors)};
  for (auto fact : {taskFact(diagnosis), evidenceFact(diagnosis)}) {
    if (fact) {
      facts.push_back(*std::move(fact));
    }
  }
  facts.push_back(
      alarmFact(diagnosis.at("alarm").number(probability), verdict == "unknown-effect" || verdict == "bad-captures"));
  facts.push_back(lackOfFitFact(diagnosis.at("lackOfFit")));
  if (scatter > 0) {
    facts.push_back({fmt::format("{:.3f}°", degrees(scatter)),
                     "by which joints deflect at random from pose to pose (1 sigma) beyond what the model explains."});
  }
  return facts;
}

} // namespace naocal
