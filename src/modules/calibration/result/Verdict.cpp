#include "calibration/result/Verdict.hpp"

#include "calibration/Outliers.hpp"
#include "calibration/Task.hpp"
#include "calibration/Uncertainty.hpp"
#include "calibration/result/Wording.hpp"
#include "effects/Catalogue.hpp"
#include "inference/Thresholds.hpp"
#include "io/Units.hpp"
#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

namespace naocal {

namespace {

/// Whether a term can do what an offset does: an unknown placement, a camera's mount, or the drawing's step to a joint.
bool canImitate(const Term& term) {
  const std::string& name = term.effect.name;
  return term.isPlacement || name == effectName::linkGeometry || name == effectName::cameraRotation ||
         name == effectName::cameraTranslation;
}

/// The imitator that an offset is most correlated with.
const Term* findImitator(const Model& model, const CalibrationResult& result, const Term& offset) {
  const auto own = static_cast<Eigen::Index>(offset.first);
  const Term* best = nullptr;
  double most = 0;
  for (const Term& term : model.terms()) {
    for (std::size_t i = 0; i < term.effect.unknowns.size() && canImitate(term); ++i) {
      const auto other = static_cast<Eigen::Index>(term.first + i);
      const double share = std::abs(result.covariance(own, other)) / std::sqrt(result.covariance(other, other));
      if (share > most) {
        most = share;
        best = &term;
      }
    }
  }
  return best;
}

/// Whether an offset of a robot with a URDF is not determined only because unknown placements or the drawing's steps do
/// what it does: with these known it would be.
bool isHeld(const Measurements& measurements, const Model& model, const CalibrationResult& result, const Term& offset) {
  if (!measurements.quantities.scene().hasLinkSteps || offset.effect.name != effectName::jointOffset ||
      result.estimates[offset.first].learned >= threshold::learned) {
    return false;
  }
  std::vector<Eigen::Index> imitators;
  for (const Term& term : model.terms()) {
    for (std::size_t i = 0; i < term.effect.unknowns.size() && canImitate(term); ++i) {
      imitators.push_back(static_cast<Eigen::Index>(term.first + i));
    }
  }
  const auto own = static_cast<Eigen::Index>(offset.first);
  const Eigen::MatrixXd& covariance = result.covariance;
  const Eigen::VectorXd scales = covariance.diagonal()(imitators).cwiseSqrt();
  const Eigen::MatrixXd among =
      scales.cwiseInverse().asDiagonal() * covariance(imitators, imitators) * scales.cwiseInverse().asDiagonal();
  const Eigen::VectorXd with = covariance.col(own)(imitators).cwiseQuotient(scales);
  const double left = covariance(own, own) - with.dot(among.completeOrthogonalDecomposition().solve(with));
  return std::sqrt(std::max(0.0, left)) < (1 - threshold::learned) * offset.effect.unknowns.front().sigma;
}

/// Offsets that another term imitates: first unknown -> that term.
using HeldOffsets = std::map<std::size_t, const Term*>;

HeldOffsets findHeldOffsets(const Measurements& measurements, const Model& model, const CalibrationResult& result) {
  HeldOffsets held;
  for (const Term& term : model.terms()) {
    if (isHeld(measurements, model, result, term)) {
      if (const Term* const imitator = findImitator(model, result, term)) {
        held.emplace(term.first, imitator);
      }
    }
  }
  return held;
}

/// Whether the answer is precise enough with a cause missing: the task's bound is within its tolerance, or without a
/// task half of every offset's 95 % interval within half a degree.
bool isPreciseEnough(const Model& model, const CalibrationResult& result, const HeldOffsets& held) {
  constexpr double widest = radians(0.5); // [rad]
  if (result.task) {
    return result.task->bound <= result.task->tolerance;
  }
  return std::all_of(model.terms().begin(), model.terms().end(), [&](const Term& term) {
    if (term.effect.name != effectName::jointOffset || !term.requested || held.contains(term.first)) {
      return true;
    }
    const auto [low, high] = result.estimates[term.first].interval();
    return high - low < 2 * widest;
  });
}

/// Whether the model explains the captures, and if not, whether the answer remains reliable.
ResultVerdict judgeExplained(const Model& model, const CalibrationResult& result, const HeldOffsets& held,
                             bool missing) {
  const bool fits =
      result.misfitLeft < threshold::mostMisfit(result.misfitFreedom) || result.rmsPx < result.noiseFloorPx;
  if (!missing && fits && result.noise.pose < suspectScatter) {
    return ResultVerdict::good;
  }
  const bool holds = result.misfitLeft < threshold::bearableMisfit && isPreciseEnough(model, result, held);
  return holds ? ResultVerdict::causeMissing : ResultVerdict::doNotUse;
}

std::string words(const DisplacedBoardCount& displaced) {
  return fmt::format("{} of {} board views {} not lie where the others put {}", displaced.moved, displaced.all,
                     displaced.moved == 1 ? "does" : "do", displaced.moved == 1 ? "it" : "them");
}

/// rms distance of all corners except those of displaced boards [px].
double rmsWithoutMoved(const CalibrationResult& result) {
  std::vector<BoardResidual> kept = result.withReportedAngles;
  std::erase_if(kept, [&](const BoardResidual& board) {
    return std::any_of(result.outliers.begin(), result.outliers.end(), [&](const Outlier& outlier) {
      return outlier.whole && outlier.picture == board.picture && outlier.observation == board.observation;
    });
  });
  return summarizeDistances(collectDistances(kept)).rmsPx;
}

/// For example "the error is 4.49 px, the noise floor 0.65 px".
std::string formatSizes(const CalibrationResult& result, const DisplacedBoardCount& displaced) {
  if (!result.readings.empty() && result.residuals.empty()) {
    return fmt::format("the error is {}, {:.1f} times what noise explains", formatSizes(result.readings),
                       result.rmsPx / result.noiseFloorPx);
  }
  return fmt::format("{}the error is {:.2f} px, the noise floor {:.2f} px",
                     displaced.any() ? words(displaced) + "; without " + (displaced.moved == 1 ? "it " : "them ")
                                     : std::string{},
                     displaced.any() ? rmsWithoutMoved(result) : result.rmsPx, result.noiseFloorPx);
}

/// An offset's sigma with its unit: "5.7°", "3.1 mm".
std::string formatSigma(const Term& offset, double sigma) {
  const auto [unit, factor] = displayUnit(offset.effect.unknowns.front().unit);
  return appendUnit(fmt::format("{:.1f}", factor * sigma), unit);
}

using About = Warning::About;

void warn(About about, std::string sentence, CalibrationResult& result) {
  result.warnings.push_back({about, std::move(sentence)});
}

/// How far apart the poses take a joint [rad, m].
double rangeOf(std::size_t joint, const Measurements& measurements) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const ImageObservation& picture : measurements.pictures) {
    const double angle = picture.instant.q[eigenIndex(joint)];
    low = std::min(low, angle);
    high = std::max(high, angle);
  }
  return high - low;
}

/// Warns of offsets that the captures do not determine; such a result is unusable.
void checkOffsets(const Measurements& measurements, const Model& model, const HeldOffsets& held,
                  CalibrationResult& result) {
  constexpr double far = 0.3; // [rad, m]: a joint that moves so far would show, if what is measured moved with it
  for (const Term& term : model.terms()) {
    const Estimate& estimate = result.estimates[term.first];
    if (term.effect.name == effectName::jointOffset && term.requested && !held.contains(term.first) &&
        estimate.learned < threshold::learned) {
      result.usable = false;
      warn(About::offset,
           fmt::format(
               "{} cannot be learned from these captures ({:.0f} % learned, ±{}): "
               "{}, or leave it out with --without {}",
               describeUnknown(term, 0), 100 * estimate.learned, formatSigma(term, estimate.sigma),
               rangeOf(term.placeIndex, measurements) < far
                   ? "add poses that move it"
                   : "it moves, but what is measured hardly moves with it; measure something further from its axis",
               term.label()),
           result);
    }
  }
}

/// Warns of offsets that other terms imitate. The result stays usable: beside placements, which nothing holds, they
/// stay at zero; with other effects, as large as is plausible of each, they share what the captures tell.
void warnOfHeldOffsets(const Model& model, const HeldOffsets& held, CalibrationResult& result) {
  for (const Term& term : model.terms()) {
    if (const auto found = held.find(term.first); found != held.end()) {
      warn(About::offset,
           fmt::format("{} cannot be told from {}{} (±{})", describeUnknown(term, 0), describeImitator(*found->second),
                       found->second->isPlacement ? " and is held at zero" : "; only what both do together is known",
                       formatSigma(term, result.estimates[term.first].sigma)),
           result);
    }
  }
}

/// Warns of a large floor error; such a result is unusable.
void checkFloorError(CalibrationResult& result) {
  constexpr double largest = 0.05; // [m]
  if (result.floorErrorAt2m > largest) {
    result.usable = false;
    warn(About::floor,
         fmt::format("a floor point 2 m ahead would be seen {:.0f} mm off (1 sigma); at most {:.0f} mm "
                     "is good enough to play: take more poses or more boards",
                     1e3 * result.floorErrorAt2m, 1e3 * largest),
         result);
  }
}

/// Warns of a bound beyond the tolerance. Such a result is unusable if the user gave that tolerance; else the bound
/// only decides where a cause is missing (`judgeExplained`).
void checkTask(bool isGiven, CalibrationResult& result) {
  if (result.task && result.task->isGiven == isGiven && result.task->bound > result.task->tolerance) {
    result.usable = result.usable && !isGiven;
    warn(About::floor,
         fmt::format(
             "{}: the bound of the error, {:.2g} mm (99.95 %), is beyond the tolerance of {:.2g} mm: take more poses",
             result.task->what, 1e3 * result.task->bound, 1e3 * result.task->tolerance),
         result);
  }
}

/// Warns of doubtful measurements of one kind: "corner", "reading".
void warnOfDoubtful(std::size_t count, const char* kind, CalibrationResult& result) {
  if (count > 0) {
    const bool single = count == 1;
    warn(About::fit,
         fmt::format("{} {}{} {} not fit the rest and got little or no weight: listed under doubtful", count, kind,
                     single ? "" : "s", single ? "does" : "do"),
         result);
  }
}

/// Warns of measurements that lie far from the likeliest explanation and share something.
void warnOfSharedCause(CalibrationResult& result) {
  if (!result.sharedCauses.empty()) {
    const SharedCause& first = result.sharedCauses.front();
    warn(About::fit,
         fmt::format(
             "the measurements that fit worst share {} (p = {:.1g}): they are no accidents, and keep their weight",
             first.driver, first.p),
         result);
  }
}

void warnOfOutliers(CalibrationResult& result) {
  std::size_t corners = 0;
  for (const Outlier& outlier : result.outliers) {
    corners += outlier.corners.size();
  }
  warnOfDoubtful(result.doubtfulReadings.size(), "reading", result);
  warnOfDoubtful(corners, "corner", result);
}

/// The most probable cause of the misfit, if something is missing.
std::string formatCause(const CalibrationResult& result, bool missing) {
  if (!missing || result.explanations.empty() || result.explanations.front().effects.empty()) {
    return "no single cause stands out";
  }
  const Explanation& likeliest = result.explanations.front();
  return fmt::format("most probable: {}{}{} (posterior probability {:.0f} % among the models considered)",
                     fmt::join(likeliest.effects, " and "), likeliest.without.empty() ? "" : " instead of ",
                     fmt::join(likeliest.without, " and "), 100 * likeliest.weight);
}

} // namespace

std::string formatVerdict(const CalibrationResult& result, const DisplacedBoardCount& displaced,
                          const std::string& cause, const std::string& firm) {
  switch (result.verdict) {
  case ResultVerdict::good:
    return fmt::format("This calibration is good: the model explains the captures ({}).",
                       formatSizes(result, displaced));
  case ResultVerdict::causeMissing:
    return fmt::format("Usable, but a cause is missing: {}; {}. The intervals of the offsets already include this "
                       "uncertainty. Find it with 'naocal diagnose'.",
                       formatSizes(result, displaced), cause);
  case ResultVerdict::doNotUse:
    return firm.empty()
               ? fmt::format("Do not use this calibration yet: {}; {}, and the offsets depend on it. Find it with "
                             "'naocal diagnose'.",
                             formatSizes(result, displaced), cause)
               : fmt::format("Do not use this calibration: {}.", firm);
  }
  return {};
}

void judgeResult(const Measurements& measurements, const Model& model, CalibrationResult& result) {
  result.weak = findWeakDirections(model, result);
  result.floorErrorAt2m = predictFloorErrorAt2m({measurements, model, result});
  result.usable = result.converged;
  if (!result.converged) {
    warn(About::fit, "the search did not converge: try --restarts 20, and check the robot's model and the boards",
         result);
  }
  const HeldOffsets held = findHeldOffsets(measurements, model, result);
  checkOffsets(measurements, model, held, result);
  checkFloorError(result);
  checkTask(true, result);
  const bool missing = (result.pValue <= threshold::alarm && result.matters) || !result.sharedCauses.empty();
  const DisplacedBoardCount displaced{measurements, result.outliers};
  // reports a missing effect first: it implies that the offsets are uncertain
  const std::string firm =
      result.usable || (missing && result.converged) ? std::string{} : result.warnings.front().sentence;
  result.verdict =
      result.usable ? judgeExplained(model, result, held, missing || displaced.areMany()) : ResultVerdict::doNotUse;
  result.usable = result.verdict != ResultVerdict::doNotUse;
  result.sentence = formatVerdict(result, displaced, formatCause(result, missing), firm);
  warnOfHeldOffsets(model, held, result);
  checkTask(false, result);
  warnOfOutliers(result);
  warnOfSharedCause(result);
}

std::string toString(ResultVerdict verdict) {
  switch (verdict) {
  case ResultVerdict::good:
    return "good";
  case ResultVerdict::causeMissing:
    return "cause-missing";
  case ResultVerdict::doNotUse:
    return "do-not-use";
  }
  return {};
}

std::vector<std::string> toSentences(const std::vector<Warning>& warnings) {
  std::vector<std::string> result;
  for (const Warning& warning : warnings) {
    result.push_back(warning.sentence);
  }
  return result;
}

} // namespace naocal
