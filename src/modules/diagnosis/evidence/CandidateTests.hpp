#pragma once

#include "calibration/Calibration.hpp"
#include "inference/Evidence.hpp"
#include "inference/WideModel.hpp"

#include <optional>
#include <string>
#include <vector>

namespace naocal {

struct CandidateTestOptions {
  Eigen::Index draws = 199; // of pure noise, for the alarm's null distribution
  std::uint64_t seed = 1;
  bool map = true; // joints and mounts over drivers beside the candidates
};

/// A fitted model put to the question: which of these candidates, and which curve of a joint or mount over a driver,
/// would explain what is left over? All linearised at the fit, and at its levels of noise: what a candidate explains
/// must not depend on how much was taken for noise without it.
class CandidateTests {
public:
  CandidateTests(const FittedModel& fitted, const std::vector<Term>& candidates,
                 const CandidateTestOptions& options = {});

  const std::vector<Term>& candidates() const { return wide_.candidates(); }
  const std::vector<PoseRows>& poses() const { return wide_.poses(); }
  const std::vector<MountCurve>& mounts() const { return wide_.mounts(); }
  const DriverColumns& map() const { return wide_.map(); }
  const ScoreProblem& problem() const { return wide_.problem(); }
  const Evidence& evidence() const { return evidence_; }
  const Noise& noise() const { return noise_; }

  /// Places among the candidates, the likeliest first.
  std::vector<std::size_t> candidatesByEvidence() const;

  /// What candidates are shown in the order of: 2 ln of the Bayes factor with that of two priors which is kinder to the
  /// candidate, the sizes that are plausible or the information of one number of the captures, six to a pose (BIC). The
  /// plausible sizes alone put an effect that is small but beyond doubt behind others that are nothing (Lindley,
  /// Biometrika 44 (1957) 187): where 0.3 +- 0.1 px are measured of a lens that may be off by 10, that costs 20.
  double rankingScore(const GroupEvidence& evidence) const;
  std::vector<std::size_t> candidatesByRank() const;
  /// Places among the curves (the mounts', then the map's cells), the one that explains most first.
  std::vector<std::size_t> curvesByEvidence() const;

  /// The place of a candidate among them, by its label.
  std::optional<std::size_t> findCandidate(const std::string& label) const;
  const GroupEvidence& candidateEvidence(std::size_t candidate) const { return evidence_.groups[candidate]; }
  /// The shape of a curve, and over which driver.
  const DriverBasis& curveBasis(std::size_t curve) const {
    return curve < mounts().size() ? mounts()[curve].cell : map().cells[curve - mounts().size()];
  }
  std::size_t curveCount() const { return mounts().size() + map().cells.size(); }
  const GroupEvidence& curveEvidence(std::size_t curve) const { return evidence_.groups[candidates().size() + curve]; }

private:
  Noise noise_;
  WideModel wide_;
  Evidence evidence_;
};

} // namespace naocal
