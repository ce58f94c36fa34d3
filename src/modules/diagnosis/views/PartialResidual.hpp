#pragma once

#include "calibration/CandidateTests.hpp"
#include "diagnosis/views/DriverCurves.hpp"
#include "diagnosis/views/SingleJointCorrection.hpp"
#include "inference/DriverBasis.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Partial residuals of an effect: its own part plus what the model with the effect leaves (component-plus-residual
/// plot: Larsen and McCleary, Technometrics 14 (1972) 781). `own` + `left` is the misfit without the effect, all else
/// as fitted with it; `left` the misfit with it.
struct PartialResidual {
  struct Point {
    std::vector<std::size_t> pictures;
    double over = 0;          // what drives the effect [`overUnit`]
    double own = 0, left = 0; // [`unit`]
    double sigma = 0;         // standard error of `left`
  };
  std::string label;          // of the effect: "elasticity@LKneePitch"
  std::string error;          // what is off: "LKneePitch"; empty: displacements in the direction of the effect
  std::string over;           // "the torque on LKneePitch"; empty: the size of the effect's own displacement
  std::string unit, overUnit; // "rad", "m" or, of displacements, "px"; "Nm"
  std::vector<Point> points;  // per encoder reading of a joint's pose; of displacements per pose

  /// Root mean squares without and with the effect [`unit`].
  double before() const;
  double after() const;
};

/// A model with the effect, its fit, the tests at that fit, and the joints' corrections there.
struct ExplainedModel {
  const FittedModel& fitted;
  const CandidateTests& candidateTests;
  const std::vector<SingleJointCorrection>& left;
};

/// Of a term of the model. An effect that turns a joint: the joint's error over the recorded driver that its part
/// follows most closely (linear correlation). Others: displacements, all of a pose's measurements together,
///
///   own = sqrt(2 |J v|^2 / n),  left = -own (J v)^T Sigma^-1 r / h,  sigma = own / sqrt(h),  h = (J v)^T Sigma^-1 J v
///
/// with the estimate v of its unknowns and n image coordinates. Absent where the effect moves nothing.
std::optional<PartialResidual> computePartialResidual(const ExplainedModel& explained, const Term& term,
                                                      const std::vector<DriverSeries>& recorded);

/// Of a curve of a joint over a driver that the model lacks: its own part is the curve less its mean, which the joint's
/// offset follows; what it leaves is the joint's correction less that part. Absent for curves of mounts, boards and
/// lenses.
std::optional<PartialResidual> computePartialResidual(const ExplainedModel& explained, const DriverCurve& curve,
                                                      const std::vector<DriverSeries>& recorded);

} // namespace naocal
