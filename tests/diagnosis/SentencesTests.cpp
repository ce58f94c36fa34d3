#include "calibration/result/Verdict.hpp"
#include "calibration/result/Wording.hpp"
#include "diagnosis/DiagnosisWording.hpp"
#include "effects/Catalogue.hpp"
#include "io/Files.hpp"
#include "math/Angles.hpp"
#include "robot/Robot.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <sstream>

namespace naocal {
namespace {

/// Lines "name: sentence" for a fixed table of inputs.
class Sentences {
public:
  void add(const std::string& name, const std::string& sentence) { lines_.push_back(name + ": " + sentence); }
  void heading(const std::string& words) {
    if (!lines_.empty()) {
      lines_.emplace_back();
    }
    lines_.push_back("# " + words);
  }
  const std::vector<std::string>& lines() const { return lines_; }

private:
  std::vector<std::string> lines_;
};

/// A finding with these estimates and sigmas [SI].
CandidateFinding found(Effect effect, const std::string& place, const std::vector<double>& sizes,
                       const std::vector<double>& sigmas) {
  CandidateFinding result;
  result.term = {.effect = std::move(effect), .placeName = place};
  result.state = CandidateState::present;
  result.evidence.estimate = Eigen::Map<const Eigen::VectorXd>(sizes.data(), std::ssize(sizes));
  const Eigen::VectorXd sigma = Eigen::Map<const Eigen::VectorXd>(sigmas.data(), std::ssize(sigmas));
  result.evidence.covariance = sigma.cwiseAbs2().asDiagonal();
  return result;
}

SelectionStep rung(const std::string& added, double heldOut, double floor) {
  SelectionStep step;
  step.added = added;
  step.heldOutPx = heldOut;
  step.noiseFloorPx = floor;
  return step;
}

Diagnosis softKnee() {
  Diagnosis result;
  result.verdict = Verdict::effectMissing;
  result.ranking = {found(elasticity(), "LKneePitch", {radians(0.475)}, {radians(0.009)})};
  result.suggested = {"elasticity@LKneePitch"};
  result.steps = {rung("", 4.3, 0.6), rung("elasticity@LKneePitch", 0.65, 0.53)};
  return result;
}

DriverCurve curve(const std::string& place, const std::string& driver, const std::string& what, double amplitude) {
  DriverCurve result;
  result.place = place;
  result.driver = driver;
  result.what = what;
  result.amplitude = amplitude;
  return result;
}

void addCalibrationVerdicts(Sentences& all) {
  all.heading("verdicts of a calibration");
  CalibrationResult result;
  result.rmsPx = result.rejected.presentPx = result.rejected.keptPx = 4.49;
  result.noiseFloorPx = 0.65;
  const auto verdictWith = [&](std::size_t displaced, const std::string& cause, const std::string& firm = "") {
    CalibrationResult here = result;
    here.rejected.views = displaced;
    here.rejected.ofViews = 120;
    return formatVerdict(here, cause, firm);
  };
  const std::string cause = "the likeliest cause is elasticity@LKneePitch (probability 69 %)";
  for (const ResultVerdict verdict : {ResultVerdict::good, ResultVerdict::causeMissing, ResultVerdict::doNotUse}) {
    result.verdict = verdict;
    all.add(toString(verdict), verdictWith(0, cause));
    all.add(toString(verdict) + ", one board moved", verdictWith(1, cause));
    all.add(toString(verdict) + ", three boards moved", verdictWith(3, cause));
  }
  result.verdict = ResultVerdict::causeMissing;
  result.rejected = {.corners = 12, .ofCorners = 7654, .presentPx = 4.49, .keptPx = 0.66};
  all.add("cause-missing, corners rejected", verdictWith(0, cause));
  all.add("cause-missing, corners rejected and boards moved", verdictWith(3, cause));
  result.verdict = ResultVerdict::doNotUse;
  all.add("do-not-use, for a reason", verdictWith(0, cause, "the search did not converge"));
}

void addDiagnosisVerdicts(Sentences& all) {
  all.heading("verdicts of a diagnosis");
  const auto add = [&](const std::string& which, const Diagnosis& diagnosis) {
    all.add(toString(diagnosis.verdict) + which, summarize(diagnosis));
  };
  Diagnosis adequate;
  adequate.rmsPx = 0.6;
  adequate.lackOfFit.noiseFloorPx = 0.53;
  adequate.alarm = 0.42;
  add("", adequate);
  adequate.alarm = 0.005;
  add(", rare", adequate);
  adequate.ranking = {found(elasticity(), "LKneePitch", {radians(0.02)}, {radians(0.003)})};
  adequate.ranking[0].state = CandidateState::trivial;
  adequate.ranking[0].evidence.movedPx = 0.043;
  add(", a small effect beyond chance", adequate);

  Diagnosis missing = softKnee();
  add("", missing);
  missing.ranking[0].equivalent = {"backlash@LKneePitch", "gearPlay@LKneePitch"};
  add(", two look alike", missing);
  missing.ranking[0].equivalent = {"a@X", "b@X", "c@X", "d@X", "e@X"};
  missing.suggested.emplace_back("rollingShutter@top");
  add(", five look alike and two are missing", missing);
  missing.ranking.push_back(found(rollingShutter(), "top", {1e-4}, {1e-5}));
  missing.ranking[1].equivalent = {"timeOffset@all"};
  add(", two are missing, and both look like others", missing);
  missing = softKnee();
  missing.rivalCurve = "LKneePitch over t";
  add(", a curve does as well", missing);
  missing = softKnee();
  missing.steps.back().heldOutPx = 4.4;
  add(", the error stays", missing);
  missing.isTentative = true;
  add(", the error stays and the evidence is weak", missing);
  missing = softKnee();
  missing.ranking[0].term.effect.description.clear();
  missing.steps.front().heldOutPx.reset();
  add(", one pose, an effect without words", missing);

  Diagnosis unknown = softKnee();
  unknown.verdict = Verdict::unknownEffect;
  unknown.suggested.clear();
  unknown.driverCurves = {curve("LKneePitch", "q", "the angle of LKneePitch", radians(0.3))};
  add(", a joint", unknown);
  unknown.driverCurves[0].expression = "a*sin(3*q)";
  unknown.suggested = {"encoderGain@HeadYaw"};
  add(", a joint, with an expression, after another effect", unknown);
  unknown.suggested = {"found_LKneePitch_over_q@LKneePitch"};
  unknown.own = OwnEffect{"found_LKneePitch_over_q@LKneePitch", "", rung("", 0.7, 0.53)};
  add(", a joint, with an effect that lowers the error", unknown);
  unknown.own.reset();
  unknown.suggested.clear();
  unknown.driverCurves[0] = curve("top", "t", "time", radians(0.1));
  unknown.driverCurves[0].about = "y";
  add(", a camera's mount", unknown);
  unknown.driverCurves[0] = curve("A", "x", "the board's columns", 0.002);
  unknown.driverCurves[0].unit = "m";
  unknown.driverCurves[0].about = "z";
  add(", a board's shape", unknown);
  unknown.driverCurves[0] = curve("bottom", "u", "the column in the picture", 1.5);
  unknown.driverCurves[0].unit = "px";
  unknown.driverCurves[0].about = "v";
  add(", a lens", unknown);

  Diagnosis scatter;
  scatter.verdict = Verdict::scatter;
  scatter.scatter = radians(0.12);
  add("", scatter);
  scatter.alarm = adequate.alarm;
  scatter.ranking = adequate.ranking;
  add(", a small effect beyond chance", scatter);

  Diagnosis open = softKnee();
  open.verdict = Verdict::inconclusive;
  open.lackOfFit.pValue = 0.003;
  add("", open);
  open.unexplained = true;
  open.alarm = 0.04;
  add(", a likeliest cause", open);

  Diagnosis bad;
  bad.verdict = Verdict::badCaptures;
  bad.anomalies = {DataAnomaly{{}, "HeadYaw's angles have the wrong sign"}};
  add("", bad);
  bad.anomalies.push_back(bad.anomalies.front());
  bad.suggested = {"encoderGain@LKneePitch"};
  add(", two, and an effect is missing", bad);
  bad.ranking = softKnee().ranking;
  bad.suggested = softKnee().suggested;
  bad.steps = softKnee().steps;
  bad.anomaliesBeside = true;
  add(", found after an effect was added", bad);

  Diagnosis still;
  still.verdict = Verdict::badCaptures;
  still.hasStillJoints = true;
  still.rmsPx = 0.6;
  still.lackOfFit.noiseFloorPx = 0.53;
  still.alarm = 0.42;
  still.fit.verdict = ResultVerdict::doNotUse;
  still.fit.findings = {{.id = "not-learned:jointOffset@elbow",
                         .level = FindingLevel::stop,
                         .why = "1 joint never moved: elbow; without motion no offset can be learned: add poses that "
                                "move it, or leave its offset out"}};
  add(", a joint that never moved", still);
}

void addStates(Sentences& all) {
  all.heading("states of candidates, as files and as people have them");
  using enum CandidateState;
  for (const CandidateState state : {present, aliased, trivial, absent, inconclusive, absorbed, noData}) {
    all.add(toString(state), describeState(state));
  }
}

void addSizes(Sentences& all) {
  all.heading("sizes");
  all.add("elasticity", formatSizes(found(elasticity(), "LKneePitch", {0.00829}, {0.00015})));
  all.add("focal length", formatSizes(found(focalLength(), "top", {0.012}, {0.0007})));
  all.add("principal point", formatSizes(found(principalPoint(), "top", {-3.25, 1e-3}, {0.21, 1000})));
  all.add("joint offset", formatSizes(found(jointOffset(), "LKneePitch", {radians(-2.2686)}, {radians(0.056)})));
  all.add("curve of a joint", formatAmplitude(curve("LKneePitch", "q", "", radians(0.3))));
  DriverCurve lens = curve("top", "u", "", 1.25);
  lens.unit = "px";
  all.add("curve of a lens", formatAmplitude(lens));
  lens.unit = "m";
  lens.amplitude = 0.00125;
  all.add("shape of a board", formatAmplitude(lens));
}

void addEffects(Sentences& all) {
  all.heading("effects, and their unknowns at a place");
  const std::map<PlaceKind, std::string> places{
      {PlaceKind::motor, "LKneePitch"}, {PlaceKind::joint, "HeadYaw"}, {PlaceKind::camera, "top"},
      {PlaceKind::board, "A"},          {PlaceKind::sole, "left"},     {PlaceKind::length, "thigh"},
      {PlaceKind::all, "all"},          {PlaceKind::stance, "0"},      {PlaceKind::tracker, "vicon"}};
  for (const Effect& effect : allEffects()) {
    all.add(effect.name, effect.description);
    for (std::size_t i = 0; i < effect.unknowns.size(); ++i) {
      const std::string& place = places.at(effect.placeKind);
      all.add(effect.name + "@" + place + "." + effect.unknowns[i].name,
              describeUnknown(Term{.effect = effect, .placeName = place}, i));
    }
  }
  all.add("enumerated", joinWords({"a"}) + "; " + joinWords({"a", "b"}) + "; " + joinWords({"a", "b", "c"}));
}

std::vector<std::string> linesOf(const std::filesystem::path& file) {
  std::istringstream text{readFile(file)};
  std::vector<std::string> result;
  for (std::string line; std::getline(text, line);) {
    result.push_back(line);
  }
  return result;
}

} // namespace

TEST_CASE("candidates that were tested one by one are not all shown as needed") {
  // Proves the state that people read: where nothing was added, several that explain the misfit could explain it each;
  // one alone is needed, and so are those of a diagnosis that added effects.
  const Effect spring = elasticity();
  Diagnosis diagnosis;
  diagnosis.steps.resize(1);
  diagnosis.ranking = {found(spring, "LKneePitch", {0.01}, {0.001}), found(spring, "LHipPitch", {0.01}, {0.001}),
                       found(spring, "LAnklePitch", {0.01}, {0.001})};
  diagnosis.ranking[0].state = CandidateState::present;
  diagnosis.ranking[1].state = CandidateState::inconclusive;
  diagnosis.ranking[2].state = CandidateState::absent;
  CHECK(shownState(diagnosis.ranking[0], diagnosis) == CandidateState::present);
  diagnosis.ranking[1].state = CandidateState::present;
  CHECK(shownState(diagnosis.ranking[0], diagnosis) == CandidateState::aliased);
  CHECK(shownState(diagnosis.ranking[1], diagnosis) == CandidateState::aliased);
  CHECK(shownState(diagnosis.ranking[2], diagnosis) == CandidateState::absent);
  diagnosis.steps.resize(2);
  CHECK(shownState(diagnosis.ranking[0], diagnosis) == CandidateState::present);
}

TEST_CASE("the sentences that people read are those of the golden file") {
  // Golden-file test: verdicts, states, effects, sizes and trends for a fixed table of inputs, line by line. To accept
  // a change, run NAOCAL_ACCEPT_SENTENCES=1 test_diagnosis "the sentences*", which rewrites the file, and review the
  // diff.
  Sentences all;
  addCalibrationVerdicts(all);
  addDiagnosisVerdicts(all);
  addStates(all);
  addSizes(all);
  addEffects(all);

  const std::filesystem::path file = std::filesystem::path{NAOCAL_SOURCE_DIR} / "tests/diagnosis/sentences.txt";
  if (std::getenv("NAOCAL_ACCEPT_SENTENCES") != nullptr) {
    std::ofstream out{file};
    for (const std::string& line : all.lines()) {
      out << line << "\n";
    }
  }
  const std::vector<std::string> golden = linesOf(file);
  for (std::size_t i = 0; i < std::max(golden.size(), all.lines().size()); ++i) {
    const std::string expected = i < golden.size() ? golden[i] : "(end of file)";
    const std::string now = i < all.lines().size() ? all.lines()[i] : "(no further line)";
    if (now != expected) {
      FAIL_CHECK(fmt::format("sentences.txt:{}\n- {}\n+ {}", i + 1, expected, now));
    }
  }
}

} // namespace naocal
