#include "report/DiagnosisSentences.hpp"

#include "math/Angles.hpp"

#include <fmt/format.h>

namespace naocal {

namespace {

constexpr Range probability{0, 1, ""};
constexpr Range pixels{0, 1e9, "px"};

/// By which the last model's joints deflect at random from pose to pose [rad].
double scatterOf(const JsonPlace& diagnosis) {
  return diagnosis.at("poseScatter").number({0, 10, "rad"});
}

std::string chance(double p) {
  return p < 0.001 ? "p < 0.001" : fmt::format("p = {:.2g}", p);
}

Fact heldOutFact(const std::vector<JsonPlace>& all, const std::string& floor) {
  const std::string noise =
      fmt::format("{} would leave {:.2f} px", floor, all.back().at("noiseFloorPx").number(pixels));
  if (all.front().at("heldOutPx").value().is_null()) {
    return {fmt::format("{:.2f} px", all.front().at("rmsPx").number(pixels)),
            "error of the fit (of one pose: none is left to try it on); " + noise + "."};
  }
  const double before = all.front().at("heldOutPx").number(pixels), after = all.back().at("heldOutPx").number(pixels);
  if (all.size() == 1) {
    return {fmt::format("{:.2f} px", before), "error on poses that the fit has not seen; " + noise + "."};
  }
  return {fmt::format("{:.2f} → {:.2f} px", before, after),
          "error on poses that neither the fit nor the choice of effects has seen, before and after adding what is "
          "suggested; " +
              noise + "."};
}

/// `found`: something that these candidates are not, within pictures.
Fact alarmFact(double alarm, bool found) {
  if (alarm <= 0.05) {
    return {chance(alarm), "so rarely would pure noise make any candidate look as striking as the best one does."};
  }
  return {chance(alarm), std::string{"so often would pure noise make some candidate look as striking as the best one "
                                     "does: "} +
                             (found ? "no reason to add one. What is told above shows by a test of its own."
                                    : "no reason to add anything.")};
}

Fact lackOfFitFact(const JsonPlace& lackOfFit) {
  return {fmt::format("{:.2f}", lackOfFit.at("statistic").number({0, 1e15, ""})),
          "is how far poses miss the base model, in chi² over its freedom: 1 is what noise makes."};
}

} // namespace

const std::vector<std::string_view>& verdicts() {
  static const std::vector<std::string_view> all{"adequate", "effect-missing", "unknown-effect",
                                                 "scatter",  "inconclusive",   "bad-captures"};
  return all;
}

const std::vector<std::string_view>& candidateStates() {
  static const std::vector<std::string_view> all{"present",      "aliased",  "trivial", "absent",
                                                 "inconclusive", "absorbed", "no-data"};
  return all;
}

std::string verdictHeadline(const JsonPlace& diagnosis) {
  static const std::vector<std::string> headlines{"The model explains these captures.",
                                                  "An effect is missing in the model.",
                                                  "Something that no known effect explains is at work.",
                                                  "Joints scatter at random.",
                                                  "It is open what is missing, if anything is.",
                                                  "Something is wrong with the captures or the set-up."};
  return headlines[diagnosis.at("verdict").oneOf(verdicts())];
}

std::string floorName(const JsonPlace& diagnosis) {
  return scatterOf(diagnosis) > 0 ? "noise and scatter" : "noise alone";
}

std::vector<Fact> diagnosisFacts(const JsonPlace& diagnosis) {
  const std::vector<JsonPlace> steps = diagnosis.at("steps").elements();
  if (steps.empty()) { // nothing could be fitted
    return {};
  }
  const double scatter = scatterOf(diagnosis);
  std::vector<Fact> facts{
      heldOutFact(steps, floorName(diagnosis)),
      alarmFact(diagnosis.at("alarm").number(probability),
                diagnosis.at("verdict").text() == "unknown-effect" || diagnosis.at("verdict").text() == "bad-captures"),
      lackOfFitFact(diagnosis.at("lackOfFit"))};
  if (scatter > 0) {
    facts.push_back({fmt::format("{:.3f}°", degrees(scatter)),
                     "by which joints deflect at random from pose to pose (1 sigma) beyond what the model explains."});
  }
  return facts;
}

} // namespace naocal
