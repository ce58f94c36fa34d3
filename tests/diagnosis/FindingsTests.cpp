#include "Questioned.hpp"
#include "SimulatedSets.hpp"

#include "diagnosis/Findings.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

/// A set without captures: names of no joints, boards or cameras.
const Measurements& nothing() {
  static const Measurements measurements{.sets = std::make_shared<const std::vector<CaptureSet>>(1)};
  return measurements;
}

Diagnosis diagnosisOf(Verdict verdict, bool usable) {
  Diagnosis diagnosis;
  diagnosis.verdict = verdict;
  diagnosis.sentence = "What is to be said.";
  diagnosis.fit.usable = usable;
  diagnosis.fit.verdict = !usable                        ? ResultVerdict::doNotUse
                          : verdict == Verdict::adequate ? ResultVerdict::good
                                                         : ResultVerdict::causeMissing;
  return diagnosis;
}

CandidateFinding candidate(const std::string& place) {
  CandidateFinding found;
  found.term = {.effect = elasticity(), .placeName = place};
  found.evidence.estimate = Eigen::VectorXd::Constant(1, 0.01);
  found.evidence.covariance = Eigen::MatrixXd::Constant(1, 1, 1e-6);
  found.evidence.bayes = 321;
  return found;
}

std::vector<std::string> idsOf(const std::vector<Finding>& findings) {
  std::vector<std::string> ids;
  for (const Finding& finding : findings) {
    ids.push_back(toString(finding.level) + " " + finding.id);
  }
  return ids;
}

using Ids = std::vector<std::string>;

} // namespace

TEST_CASE("every verdict of a diagnosis has a finding of its kind and level") {
  // Proves kinds and levels: what is missing stops only where the model as given must not be used.
  CHECK(idsOf(listFindings(diagnosisOf(Verdict::adequate, true), nothing())) == Ids{"note good"});
  CHECK(idsOf(listFindings(diagnosisOf(Verdict::scatter, true), nothing())) == Ids{"act noise:joint-scatter"});
  CHECK(idsOf(listFindings(diagnosisOf(Verdict::inconclusive, false), nothing())) == Ids{"stop unknown-effect:misfit"});
  Diagnosis missing = diagnosisOf(Verdict::effectMissing, true);
  missing.ranking = {candidate("knee"), candidate("hip")};
  missing.suggested = {"elasticity@knee", "elasticity@hip"};
  const std::vector<Finding> both = listFindings(missing, nothing());
  CHECK(idsOf(both) == Ids{"act effect-missing:elasticity@knee", "act effect-missing:elasticity@hip"});
  CHECK(both[0].sentence == missing.sentence);
  CHECK(both[0].numbers.at("evidence") == 321);
  CHECK(both[1].sentence.starts_with("elasticity@hip is missing (c = 0.57"));
  missing.fit.usable = false;
  CHECK(listFindings(missing, nothing())[1].level == FindingLevel::stop);
  Diagnosis unknown = diagnosisOf(Verdict::unknownEffect, true);
  unknown.driverCurves.emplace_back();
  unknown.driverCurves.front().place = "knee";
  unknown.driverCurves.front().driver = "q";
  CHECK(idsOf(listFindings(unknown, nothing())) == Ids{"act unknown-effect:knee over q"});
  unknown.suggested = {"elasticity@hip", "found_knee_over_q@knee"};
  unknown.own = OwnEffect{.label = "found_knee_over_q@knee"};
  CHECK(idsOf(listFindings(unknown, nothing())) ==
        Ids{"act effect-missing:elasticity@hip", "act unknown-effect:knee over q"});
}

TEST_CASE("accidents and mistakes of the set-up stop, and say what they concern") {
  // Proves ids, places and answers; that what explains more stands first; and that its sentence is the diagnosis'.
  Diagnosis bad = diagnosisOf(Verdict::badCaptures, true);
  bad.anomalies = {{.why = "the knee's angles have the wrong sign", .odds = 1e4, .setUp = "reversedJoint@knee"},
                   {.capture = 17, .why = "board A lies elsewhere in capture 17", .moved = "A"},
                   {.why = "the tracker was moved", .moved = "tracker"}};
  const std::vector<Finding> findings = listFindings(bad, nothing());
  CHECK(idsOf(findings) == Ids{"stop set-up:reversedJoint@knee", "stop accident:capture-17@A", "stop event:tracker"});
  CHECK(findings[0].sentence == bad.sentence);
  CHECK(findings[0].numbers.at("odds") == 1e4);
  CHECK(findings[0].answers.front().what == "reversedJoint@knee");
  CHECK(findings[1].where.captures == std::vector{17});
  std::swap(bad.anomalies[0], bad.anomalies[1]);
  CHECK(listFindings(bad, nothing()).front().id == "set-up:reversedJoint@knee"); // of which the sentence tells
  bad.suggested = {"elasticity@knee"};
  bad.ranking = {candidate("knee")};
  bad.anomaliesBeside = true;
  CHECK(listFindings(bad, nothing()).front().id == "effect-missing:elasticity@knee");
}

TEST_CASE("a model that explains its captures is not called good where the result must not be used") {
  // Proves that what was not learned takes the place of "good", and that what the fit alone says of a cause is dropped.
  Diagnosis adequate = diagnosisOf(Verdict::adequate, false);
  adequate.fit.findings = {
      {.id = "not-learned:jointOffset@knee", .level = FindingLevel::stop, .why = "the knee never moved"},
      {.id = "effect-missing:elasticity@knee",
       .level = FindingLevel::stop,
       .why = "the error is large",
       .isVerdict = true},
      {.id = "weak:task", .level = FindingLevel::note, .why = "the bound is wide"}};
  const std::vector<Finding> findings = listFindings(adequate, nothing());
  CHECK(idsOf(findings) == Ids{"stop not-learned:jointOffset@knee", "note weak:task"});
  Diagnosis doubted = diagnosisOf(Verdict::adequate, true); // p is large, but the fit leaves more than noise
  doubted.fit.verdict = ResultVerdict::causeMissing;
  doubted.fit.findings = {
      {.id = "unknown-effect:misfit", .level = FindingLevel::act, .why = "the error is large", .isVerdict = true}};
  CHECK(idsOf(listFindings(doubted, nothing())) == Ids{"act unknown-effect:misfit"});
  CHECK(findings[0].sentence == adequate.sentence);
  CHECK(findings[1].sentence == "The bound is wide.");
}

} // namespace naocal
