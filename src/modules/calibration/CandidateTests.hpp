#pragma once

#include "calibration/result/CalibrationResult.hpp"
#include "inference/Evidence.hpp"
#include "inference/WideModel.hpp"

#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Tests of a fitted model: which candidate effect, and which curve of a joint or mount over a driver, would explain
/// the residuals. All linearised at the fit and at its noise levels, so that a candidate's evidence does not depend on
/// how much misfit counts as noise without it.
class CandidateTests {
public:
  CandidateTests(const FittedModel& fitted, const std::vector<Term>& candidates,
                 const CandidateTestOptions& options = {});

  const std::vector<Term>& candidates() const { return wide_.candidates(); }
  const std::vector<PoseRows>& poses() const { return wide_.poses(); }
  const std::vector<MountCurve>& mounts() const { return wide_.mounts(); }
  const DriverColumns& map() const { return wide_.map(); }
  const WideModel& wide() const { return wide_; }
  const ScoreProblem& problem() const { return wide_.problem(); }
  const MeasuredTests& measured() const { return measured_; }
  const Evidence& evidence() const { return evidence_; }
  const Noise& noise() const { return measured_.alone.noise(); }

  /// Indices of the candidates, likeliest first.
  std::vector<std::size_t> candidatesByEvidence() const;

  /// Display order of candidates: 2 ln(Bayes factor) under the more favourable of two priors, the plausible sizes or
  /// the information of one image coordinate, six per pose (BIC). The plausible sizes alone rank a small but certain
  /// effect behind absent ones (Lindley, Biometrika 44 (1957) 187): for a lens parameter measured as 0.3 +- 0.1 px with
  /// a prior of 10 px, the penalty is 20.
  double rankingScore(const GroupEvidence& evidence) const;
  std::vector<std::size_t> candidatesByRank() const;
  /// Indices of the curves (the mounts', then the map's cells), most evidence first.
  std::vector<std::size_t> curvesByEvidence() const;

  /// Index of a candidate by its label.
  std::optional<std::size_t> findCandidate(const std::string& label) const;
  const GroupEvidence& candidateEvidence(std::size_t candidate) const { return evidence_.groups[candidate]; }
  /// Basis of a curve, with its driver.
  const DriverBasis& curveBasis(std::size_t curve) const {
    return curve < mounts().size() ? mounts()[curve].cell : map().cells[curve - mounts().size()];
  }
  std::size_t curveCount() const { return mounts().size() + map().cells.size(); }
  const GroupEvidence& curveEvidence(std::size_t curve) const { return evidence_.groups[candidates().size() + curve]; }

private:
  WideModel wide_;
  MeasuredTests measured_;
  Evidence evidence_;
};

} // namespace naocal
