#include "diagnosis/views/EffectSignature.hpp"

#include "diagnosis/views/AddedVariable.hpp"
#include "diagnosis/views/ResidualField.hpp"
#include "estimation/DriverState.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace naocal {

namespace {

constexpr Eigen::Index cornersPerPicture = 30, cornersPerCamera = 180; // upper limits of displayed corners

/// The estimate if its evidence is positive; else a plausible size in the same direction.
Eigen::VectorXd displaySize(const GroupEvidence& evidence, const Effect& effect) {
  Eigen::VectorXd sigmas(evidence.estimate.size());
  for (Eigen::Index i = 0; i < sigmas.size(); ++i) {
    sigmas[i] = effect.unknowns[static_cast<std::size_t>(i)].sigma;
  }
  const double length = evidence.estimate.cwiseQuotient(sigmas).norm();
  if (evidence.bayes > 0) {
    return evidence.estimate;
  }
  return length > 0 ? Eigen::VectorXd{evidence.estimate / length} : sigmas;
}

/// One picture of each pose and camera.
std::vector<std::size_t> selectOnePerPose(const Measurements& measurements) {
  std::vector<std::size_t> result;
  for (const PoseGroup& pose : measurements.poses) {
    std::set<std::size_t> cameras;
    for (const EncoderSample& reading : pose.readings) {
      for (std::size_t picture : reading.pictures) {
        if (cameras.insert(measurements.pictures[picture].camera).second) {
          result.push_back(picture);
        }
      }
    }
  }
  return result;
}

Eigen::Matrix2Xd joinCorners(const std::vector<PredictedBoard>& boards) {
  Eigen::Index count = 0;
  for (const PredictedBoard& board : boards) {
    count += board.corners.cols();
  }
  Eigen::Matrix2Xd result(2, count);
  for (const PredictedBoard& board : boards) {
    result.middleCols(result.cols() - count, board.corners.cols()) = board.corners;
    count -= board.corners.cols();
  }
  return result;
}

double rms(const Eigen::Matrix2Xd& shifts) {
  return std::sqrt(shifts.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, shifts.cols())));
}

/// Displacements by an effect, before and after refitting; absent if a corner has no projection.
std::optional<EffectSignature::Seen> computeShifts(std::size_t picture, const Eigen::Matrix2Xd& flawed,
                                                   const Eigen::Matrix2Xd& model, const Eigen::Matrix2Xd& refitted) {
  const Eigen::Matrix2Xd before = flawed - model, after = flawed - refitted;
  if (!before.allFinite() || !after.allFinite()) {
    return std::nullopt;
  }
  EffectSignature::Seen seen{picture, rms(before), rms(after), {}};
  std::vector<Eigen::Index> some;
  const Eigen::Index step = (model.cols() + cornersPerPicture - 1) / cornersPerPicture;
  for (Eigen::Index i = 0; i < model.cols(); i += step) {
    some.push_back(i);
  }
  seen.corners.resize(6, eigenIndex(some.size()));
  seen.corners << model(Eigen::all, some), before(Eigen::all, some), after(Eigen::all, some);
  return seen;
}

/// Computes the overall rms and keeps the pictures with the largest displacements per camera.
void summarizeSignature(const Measurements& measurements, EffectSignature& imprint) {
  double before = 0, after = 0, count = 0;
  for (const EffectSignature::Seen& seen : imprint.pictures) {
    double corners = 0;
    for (const BoardObservation& observation : measurements.pictures[seen.picture].observations) {
      corners += static_cast<double>(observation.ids.size());
    }
    before += corners * seen.beforePx * seen.beforePx;
    after += corners * seen.afterPx * seen.afterPx;
    count += corners;
  }
  imprint.beforePx = std::sqrt(before / std::max(1.0, count));
  imprint.afterPx = std::sqrt(after / std::max(1.0, count));
  std::stable_sort(imprint.pictures.begin(), imprint.pictures.end(),
                   [](const auto& a, const auto& b) { return a.beforePx > b.beforePx; });
  std::map<std::size_t, Eigen::Index> taken; // per camera
  std::erase_if(imprint.pictures, [&](const EffectSignature::Seen& seen) {
    Eigen::Index& corners = taken[measurements.pictures[seen.picture].camera];
    corners += seen.corners.cols();
    return corners > cornersPerCamera;
  });
}

} // namespace

std::vector<EffectSignature> computeSignatures(const FittedModel& fitted, const CandidateTests& candidateTests,
                                               const std::vector<std::size_t>& candidates) {
  std::vector<EffectSignature> result;
  std::vector<Eigen::VectorXd> refitted;
  for (std::size_t candidate : candidates) {
    const GroupEvidence& evidence = candidateTests.candidateEvidence(candidate);
    EffectSignature& imprint = result.emplace_back();
    imprint.found = evidence.bayes > 0;
    imprint.size = displaySize(evidence, candidateTests.candidates()[candidate].effect);
    const CandidateColumn column{candidateTests, candidate, imprint.size, candidateTests.noise()};
    imprint.imitator = termLabel(fitted.model, column.like);
    refitted.push_back(fitted.fit.unknowns + column.imitation);
  }
  for (std::size_t index : selectOnePerPose(fitted.measurements)) {
    const ImageObservation& picture = fitted.measurements.pictures[index];
    const RobotSample instant = sampleAt(fitted.measurements, fitted.model, picture, fitted.fit.unknowns);
    const ModelState plain = predictState(fitted.measurements, fitted.model, picture, fitted.fit.unknowns);
    const Eigen::Matrix2Xd shown = joinCorners(predictBoards(fitted.measurements, picture, plain));
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const Term& term = candidateTests.candidates()[candidates[i]];
      ModelState flawed = plain;
      for (const CorrectedPlace& place : placesOn(term, fitted.measurements, picture)) {
        place.correct(flawed, term.effect, instant, {result[i].size.data(), term.effect.unknowns.size()});
      }
      const ModelState followed = predictState(fitted.measurements, fitted.model, picture, refitted[i]);
      if (auto seen = computeShifts(index, joinCorners(predictBoards(fitted.measurements, picture, flawed)), shown,
                                    joinCorners(predictBoards(fitted.measurements, picture, followed)))) {
        result[i].pictures.push_back(std::move(*seen));
      }
    }
  }
  for (EffectSignature& imprint : result) {
    summarizeSignature(fitted.measurements, imprint);
  }
  return result;
}

} // namespace naocal
