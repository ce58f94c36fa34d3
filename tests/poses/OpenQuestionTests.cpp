#include "RobotV6.hpp"
#include "poses/criteria/Discrimination.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

CandidateFinding finding(const std::string& effect, const std::string& place, CandidateState state, double evidence) {
  CandidateFinding result;
  for (const Effect& each : allEffects()) {
    if (each.name == effect) {
      result.term.effect = each;
    }
  }
  result.term.placeName = place;
  result.state = state;
  result.evidence.bayes = evidence;
  result.evidence.freedom = 1;
  result.evidence.estimate =
      Eigen::VectorXd::Constant(static_cast<Eigen::Index>(result.term.effect.unknowns.size()), 0.004);
  return result;
}

std::vector<std::string> labels(const ModelAmbiguity& question) {
  std::vector<std::string> result;
  for (const Hypothesis& suspect : question.suspects) {
    result.push_back(suspect.label);
  }
  return result;
}

} // namespace

TEST_CASE("where no poses can help, it is said why") {
  // Proves the reasons for nothing open, bad captures, and a place where poses cannot be planned.
  Diagnosis diagnosis;
  const auto why = [&] { return findAmbiguity(diagnosis, v6(), {}).whyNone; };
  CHECK(why() == "the captures leave nothing open");
  diagnosis.verdict = Verdict::badCaptures;
  CHECK_THAT(why(), Catch::Contains("put the captures right"));
  diagnosis.verdict = Verdict::unknownEffect;
  diagnosis.driverCurves.push_back({.place = "top", .driver = "u", .unit = "px"});
  CHECK_THAT(why(), Catch::Contains("top over u"));
}

TEST_CASE("twins are asked first, then a curve's rival, then what captures hardly test") {
  // Proves the order of open questions on hand-made diagnoses.
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::effectMissing;
  diagnosis.ranking = {finding("elasticity", "LKneePitch", CandidateState::present, 30),
                       finding("backlash", "LKneePitch", CandidateState::aliased, 28),
                       finding("thermalDrift", "LHipRoll", CandidateState::inconclusive, 1),
                       finding("encoderGain", "HeadYaw", CandidateState::absent, -3)};
  diagnosis.suggested = diagnosis.with = {"elasticity@LKneePitch"};
  diagnosis.ranking[0].equivalent = {"backlash@LKneePitch"};
  const auto ask = [&] { return findAmbiguity(diagnosis, v6(), {}); };

  const ModelAmbiguity twins = ask();
  CHECK(twins.rivals);
  CHECK(labels(twins) == std::vector<std::string>{"elasticity@LKneePitch", "backlash@LKneePitch"});
  CHECK(twins.with.empty()); // the suspects are removed from the model
  CHECK(twins.suspects[0].odds == Approx(1 / (1 + std::exp(-1.0))));
  CHECK(twins.why == "tells elasticity@LKneePitch from backlash@LKneePitch");

  diagnosis.ranking[0].equivalent.clear();
  const ModelAmbiguity whether = ask();
  CHECK_FALSE(whether.rivals);
  CHECK(labels(whether) == std::vector<std::string>{"thermalDrift@LHipRoll"});
  CHECK(whether.with == std::vector<std::string>{"elasticity@LKneePitch"});
  CHECK(whether.why == "shows whether thermalDrift@LHipRoll is there");

  diagnosis.verdict = Verdict::unknownEffect;
  diagnosis.suggested = diagnosis.with = {};
  diagnosis.ranking[0].state = CandidateState::aliased;
  diagnosis.driverCurves = {{.place = "LKneePitch",
                             .driver = "q",
                             .bayes = 60,
                             .expression = "a*sin(6*q) + b*cos(6*q)",
                             .coefficients = {{"a", 0.003}, {"b", 0.001}}}};
  const ModelAmbiguity curve = ask();
  CHECK(curve.rivals);
  CHECK(labels(curve) == std::vector<std::string>{"curve@LKneePitch", "elasticity@LKneePitch"});
  CHECK(curve.suspects[0].size == Eigen::Vector2d{0.003, 0.001});
  CHECK(curve.effects.size() == allEffects().size() + 1);

  diagnosis.verdict = Verdict::badCaptures;
  CHECK(ask().suspects.empty());
  CHECK(ask().why.empty());
}

TEST_CASE("twins whose linearised evidence is worlds apart are still told by further poses") {
  // Proves that the growth of their misfits is a number: the captures cannot tell a hysteresis from a gear's play,
  // whose evidence, linearised at no play, is less by 1600, odds below all numbers. Also of questions with such odds.
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::effectMissing;
  diagnosis.ranking = {finding("hysteresis", "LAnkleRoll", CandidateState::present, 1689),
                       finding("gearPlay", "LAnkleRoll", CandidateState::aliased, 55)};
  diagnosis.suggested = diagnosis.with = {"hysteresis@LAnkleRoll"};
  diagnosis.ranking[0].equivalent = {"gearPlay@LAnkleRoll"};
  ModelAmbiguity question = findAmbiguity(diagnosis, v6(), {});
  REQUIRE(question.suspects.size() == 2);
  CHECK(question.suspects[1].odds == Approx(1 / (1 + std::exp(3.0))));
  question.suspects[0].odds = 1;
  question.suspects[1].odds = 0;
  const Discrimination discrimination{question, 0};
  const double growth = discrimination.growthFactor(Eigen::Vector2d{1, 4}, Eigen::Vector2d{4, 16});
  CHECK(growth == Approx(4).epsilon(0.01));
  CHECK(discrimination.expectedGain(Eigen::Vector2d{1, 4}, Eigen::Vector2d{1, 4}) == 0);
}

TEST_CASE("a question without suspects has no growth and no odds") {
  // Proves that empty lists lead to neutral numbers.
  const ModelAmbiguity nothing;
  const Discrimination discrimination{nothing, 0};
  CHECK(discrimination.misfits(Eigen::MatrixXd(0, 0)).size() == 0);
  CHECK(discrimination.growthFactor({}, {}) == 1);
  CHECK(posteriorProbabilities({}).empty());
}

} // namespace naocal
