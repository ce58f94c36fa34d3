#include "SharedData.hpp"
#include "diagnosis/DiagnosisFile.hpp"
#include "diagnosis/DiagnosisWording.hpp"
#include "io/Files.hpp"
#include "library/naocal.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using nlohmann::json;

Captures readConformance(const std::filesystem::path& folder, const std::string& set) {
  return readCaptures({folder / set}, std::filesystem::path{NAOCAL_SOURCE_DIR} / "home" / "configuration");
}

/// True values by "effect@place.unknown"; what is not named is zero.
std::map<std::string, double> truthOf(const std::filesystem::path& folder, const std::string& set) {
  const json truth = json::parse(readFile(folder / (set + ".truth.json")));
  std::map<std::string, double> values;
  for (const char* list : {"effects", "hidden"}) {
    for (const json& effect : truth[list]) {
      for (const auto& [key, value] : effect.items()) {
        if (value.is_number()) {
          values[effect["effect"].get<std::string>() + "@" + effect["at"].get<std::string>() + "." + key] = value;
        }
      }
    }
  }
  return values;
}

} // namespace

TEST_CASE("true values of other programs' robots lie within their intervals, and no effect is suspected", "[slow]") {
  // Proves for five sets of an independent simulator, pooled: at least 90 % of the true offsets and camera rotations
  // lie within their 95 % intervals, none lies beyond 4 sigma; each verdict is adequate. A wrist camera, a tracker, a
  // camera beside an arm, contacts with unknown places, one foot on the floor.
  const auto folder = sharedData("conformance-robots");
  if (!folder) {
    return;
  }
  std::size_t inside = 0, all = 0;
  for (const std::string set :
       {"plain-ur10-wrist", "plain-ur10-tracker", "plain-so101-beside", "plain-panda-contacts", "plain-k1-foot"}) {
    const Captures captures = readConformance(*folder, set);
    const Calibrated calibrated = calibrate(captures);
    const std::map<std::string, double> truth = truthOf(*folder, set);
    const std::vector<std::string> names = calibrated.model.names();
    for (const Term& term : calibrated.model.terms()) {
      for (std::size_t i = term.first; !term.isPlacement && i < term.first + term.effect.unknowns.size(); ++i) {
        INFO(set << " " << names[i]);
        const Estimate& estimate = calibrated.result.estimates[i];
        const double value = truth.at(names[i]);
        const auto [low, high] = estimate.interval();
        CHECK(std::abs(estimate.best() - value) < 4 * estimate.bestSigma());
        inside += low <= value && value <= high;
        ++all;
      }
    }
    INFO(set);
    const Diagnosis diagnosis = diagnose(captures);
    CHECK(toString(diagnosis.verdict) == "adequate");
    CHECK(diagnosis.suggested.empty());
  }
  CHECK(all == 38);
  CHECK(static_cast<double>(inside) >= 0.9 * static_cast<double>(all));
}

TEST_CASE("effects hidden in other programs' robots head the list, or their class does", "[slow]") {
  // Proves it for elasticity and a yielding bearing by a tracker, an eccentric encoder on one foot (its class: a gain,
  // which these angles do not tell from it), and a part that is drawn wrong beside a camera; sizes within 3 sigma.
  const auto folder = sharedData("conformance-robots");
  if (!folder) {
    return;
  }
  const std::map<std::string, std::string> expected{{"elastic-ur10", "elasticity@shoulder_lift_joint"},
                                                    {"eccentric-k1", "encoderEccentricity@Left_Knee_Pitch"},
                                                    {"link-so101", "linkGeometry@elbow_flex"}};
  for (const auto& [set, effect] : expected) {
    INFO(set);
    const Captures captures = readConformance(*folder, set);
    const Diagnosis diagnosis = diagnose(captures);
    CHECK(toString(diagnosis.verdict) == "effect-missing");
    REQUIRE_FALSE(diagnosis.ranking.empty());
    const CandidateFinding& first = diagnosis.ranking.front();
    CHECK((first.term.label() == effect ||
           std::find(first.equivalent.begin(), first.equivalent.end(), effect) != first.equivalent.end()));
    const std::map<std::string, double> truth = truthOf(*folder, set);
    std::vector<std::string> with = diagnosis.suggested;
    std::replace(with.begin(), with.end(), first.term.label(), effect);
    const Calibrated calibrated = calibrate(captures, with);
    const std::vector<std::string> names = calibrated.model.names();
    for (const auto& [name, value] : truth) {
      const auto found = std::find(names.begin(), names.end(), name);
      if (found != names.end()) {
        INFO(name);
        const Estimate& estimate = calibrated.result.estimates[static_cast<std::size_t>(found - names.begin())];
        CHECK(std::abs(estimate.value - value) < 3 * estimate.sigma);
      }
    }
  }
}

TEST_CASE("a joint that turns the other way and one whose count slipped are suspected set-ups", "[slow]") {
  // Proves both on a plain set, spoilt: the sign of one joint's readings changed, another's shifted by one motor turn.
  const auto folder = sharedData("conformance-robots");
  if (!folder) {
    return;
  }
  const Captures good = readConformance(*folder, "plain-so101-beside");
  const auto spoil = [&](const std::string& joint, double factor, double shift) {
    std::vector<CaptureSet> sets = *good.measurements.sets;
    const auto& names = sets.front().jointNames;
    const auto at = static_cast<std::size_t>(std::find(names.begin(), names.end(), joint) - names.begin());
    for (Capture& capture : sets.front().captures) {
      capture.joints.measured[at] = factor * capture.joints.measured[at] + shift;
    }
    Robot robot = readConformance(*folder, "plain-so101-beside").measurements.robot;
    return diagnose(Captures{good.sources, buildMeasurements(std::move(sets), robot)});
  };
  const Diagnosis reversed = spoil("wrist_flex", -1, 0), slipped = spoil("elbow_flex", 1, 0.41887902);
  CHECK(toString(reversed.verdict) == "bad-captures");
  REQUIRE_FALSE(reversed.anomalies.empty());
  CHECK(reversed.anomalies.front().setUp == "reversedJoint@wrist_flex");
  CHECK(toString(slipped.verdict) == "bad-captures");
  REQUIRE_FALSE(slipped.anomalies.empty());
  CHECK(slipped.anomalies.front().setUp == "countSlip@elbow_flex");
  const json written = diagnosisJson(slipped);
  CHECK(written["ranking"][0]["effect"] == "countSlip");
  CHECK(written["suspicious"][0]["setUp"] == "countSlip@elbow_flex");
}

} // namespace naocal
