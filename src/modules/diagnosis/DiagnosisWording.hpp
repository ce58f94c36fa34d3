#pragma once

#include "diagnosis/Diagnosis.hpp"

#include <string>
#include <vector>

namespace naocal {

/// File value: "effect-missing", ...
std::string toString(Verdict verdict);
/// File value: "present", ..., "no-data".
std::string toString(CandidateState state);
/// Display text of a state: "needed", "could explain", "ruled out", ...
std::string describeState(CandidateState state);

/// The state to show. Candidates of a diagnosis that added nothing were tested one by one: if several explain the
/// misfit, none is needed for certain, and each could explain it. Beside an unknown effect, what is not suggested is
/// undecided.
CandidateState shownState(const CandidateFinding& finding, const Diagnosis& diagnosis);

/// The candidate of this label; null without one.
const CandidateFinding* findCandidate(const Diagnosis& diagnosis, const std::string& label);

/// The likeliest effect, if it is beyond chance but hardly changes the predictions; null without one.
const CandidateFinding* findNegligible(const Diagnosis& diagnosis);

/// Labels of the mistakes of the set-up that it found.
std::vector<std::string> mendableSetUps(const Diagnosis& diagnosis);

/// A clause on what is wrong with the set-up; else on the first accident, and how many more. Requires one.
std::string describeAnomalies(const std::vector<DataAnomaly>& anomalies);
/// The same as a sentence.
std::string formatAnomalies(const std::vector<DataAnomaly>& anomalies);
/// Whether the suggested effects explain more than the anomalies, and come before them.
bool areBeside(const Diagnosis& diagnosis);
/// The diagnosis as one or two sentences.
std::string summarize(const Diagnosis& diagnosis);
/// The sentence of a diagnosis without any fit, and the command that mends a suspected set-up.
std::string summarizeUnfitted(const Diagnosis& diagnosis);

/// Amplitude of a curve: "±0.30°".
std::string formatAmplitude(const DriverCurve& curve);

/// Whether the captures determine an unknown of a finding: standard error at most ten prior sigmas.
bool isTold(const CandidateFinding& finding, std::size_t unknown);

/// Estimates of a finding: "c = 0.34 ± 0.02°/Nm, t undetermined".
std::string formatSizes(const CandidateFinding& finding);
/// Sizes of a finding that are detected with 90 % power: "c = 0.02°/Nm".
std::string formatDetectable(const CandidateFinding& finding);

} // namespace naocal
