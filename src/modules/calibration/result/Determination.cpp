#include "calibration/result/Determination.hpp"

#include "calibration/result/Wording.hpp"
#include "effects/Catalogue.hpp"
#include "inference/Thresholds.hpp"
#include "io/Units.hpp"
#include "math/LinearAlgebra.hpp"
#include "measurements/JointMotion.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

namespace naocal {

namespace {

/// Whether a term is a camera's mount.
bool isMount(const Term& term) {
  return term.effect.name == effectName::cameraRotation || term.effect.name == effectName::cameraTranslation;
}

/// Whether a term can do what an offset does: an unknown placement, a camera's mount, or the drawing's step to a joint.
bool canImitate(const Term& term) {
  return term.isPlacement || term.effect.name == effectName::linkGeometry || isMount(term);
}

bool isOffset(const Term& term) {
  return term.effect.name == effectName::jointOffset;
}

bool isAsked(const Term& term) {
  return term.requested && !term.isPlacement;
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

/// Standard error of an unknown if those of the terms that meet a condition were known.
template <class Condition> double sigmaGiven(const FittedModel& fitted, std::size_t unknown, const Condition& isKnown) {
  std::vector<Eigen::Index> known;
  for (const Term& term : fitted.model.terms()) {
    for (std::size_t i = term.first; i < term.first + term.effect.unknowns.size() && isKnown(term); ++i) {
      if (i != unknown) {
        known.push_back(eigenIndex(i));
      }
    }
  }
  const auto own = eigenIndex(unknown);
  const Eigen::MatrixXd& covariance = fitted.fit.covariance;
  if (known.empty()) {
    return std::sqrt(covariance(own, own));
  }
  const Eigen::VectorXd scales = covariance.diagonal()(known).cwiseSqrt();
  const Eigen::MatrixXd among =
      scales.cwiseInverse().asDiagonal() * covariance(known, known) * scales.cwiseInverse().asDiagonal();
  const Eigen::VectorXd with = covariance.col(own)(known).cwiseQuotient(scales);
  const double left = covariance(own, own) - with.dot(among.completeOrthogonalDecomposition().solve(with));
  return std::sqrt(std::max(0.0, left));
}

bool isLearned(const FittedModel& fitted, std::size_t unknown) {
  return fitted.fit.estimates[unknown].learned >= threshold::learned;
}

/// Whether an offset is learned by the captures themselves: also if nothing were known of the cameras' mounts before.
/// Without the priors of variances D of the mounts' unknowns m, the covariance C becomes C + C_.m (D - C_mm)^-1 C_m.
bool isLearnedByCaptures(const FittedModel& fitted, const Term& offset) {
  std::vector<Eigen::Index> mounts;
  for (const Term& term : fitted.model.terms()) {
    for (std::size_t i = 0; i < term.effect.unknowns.size() && isMount(term); ++i) {
      mounts.push_back(eigenIndex(term.first + i));
    }
  }
  const auto own = eigenIndex(offset.first);
  double variance = std::pow(fitted.fit.estimates[offset.first].sigma, 2);
  if (!mounts.empty()) {
    const Eigen::MatrixXd& covariance = fitted.fit.covariance;
    const Eigen::VectorXd priors = fitted.model.sigmas()(mounts);
    const Eigen::MatrixXd scaled =
        priors.cwiseInverse().asDiagonal() * covariance(mounts, mounts) * priors.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes{scaled};
    const Eigen::VectorXd with =
        axes.eigenvectors().transpose() * covariance.col(own)(mounts).cwiseQuotient(priors); // to what the prior tells
    constexpr double least = 1e-6; // share that the captures tell, at least: no prior is left without any other
    variance += (with.array().square() / (1 - axes.eigenvalues().array()).max(least)).sum();
  }
  return std::sqrt(variance) <= (1 - threshold::learned) * offset.effect.unknowns.front().sigma;
}

/// Whether an unknown of a term would be learned if those of the terms that meet a condition were known.
template <class Condition>
bool isLearnedGiven(const FittedModel& fitted, const Term& term, std::size_t i, const Condition& isKnown) {
  return sigmaGiven(fitted, term.first + i, isKnown) < (1 - threshold::learned) * term.effect.unknowns[i].sigma;
}

/// The finding that the captures do not tell a term.
Finding describeUndetermined(const FittedModel& fitted, const Term& term, std::string why) {
  Finding finding = makeFinding("not-learned", term.label(), FindingLevel::stop, std::move(why), fitted.measurements);
  finding.answers = {{"take poses", "", ""}, {"leave out", "effect", term.label()}};
  return finding;
}

Finding describeOffset(const FittedModel& fitted, const Term& term) {
  constexpr double far = 0.3; // [rad, m]: a joint that moves so far would show, if what is measured moved with it
  const Estimate& estimate = fitted.fit.estimates[term.first];
  return describeUndetermined(
      fitted, term,
      fmt::format(
          "{} cannot be learned from these captures ({:.0f} % learned, ±{}): {}, or leave its offset out",
          describeUnknown(term, 0), 100 * estimate.learned, formatSigma(term, estimate.bestSigma()),
          motionOf(term.placeIndex, fitted.measurements) < far
              ? "add poses that move it"
              : "it moves, but what is measured hardly moves with it; measure something further from its axis"));
}

/// A camera's mount or another effect, as far as the captures do not tell it.
std::optional<Finding> describeEffect(const FittedModel& fitted, const Term& term) {
  std::vector<std::string> names;
  double most = 0;
  for (std::size_t i = 0; i < term.effect.unknowns.size(); ++i) {
    if (!isLearned(fitted, term.first + i) && !isLearnedGiven(fitted, term, i, isAsked)) {
      names.push_back(describeUnknown(term, i));
      most = std::max(most, fitted.fit.estimates[term.first + i].learned);
    }
  }
  const bool isWhole = isMount(term) && !fitted.measurements.quantities.scene().hasLinkSteps;
  if (names.empty() || (!isWhole && names.size() < term.effect.unknowns.size())) {
    return std::nullopt;
  }
  return describeUndetermined(
      fitted, term,
      fmt::format("{} cannot be learned from these captures ({}{:.0f} % learned): add poses in which {} shows, or "
                  "leave {} out",
                  joinWords(names), names.size() == 1 ? "" : "at most ", 100 * most, names.size() == 1 ? "it" : "each",
                  term.label()));
}

} // namespace

HeldOffsets findHeldOffsets(const FittedModel& fitted) {
  HeldOffsets held;
  for (const Term& term : fitted.model.terms()) {
    if (!fitted.measurements.quantities.scene().hasLinkSteps || !isOffset(term) ||
        isStill(term.placeIndex, fitted.measurements) ||
        (isLearned(fitted, term.first) && isLearnedByCaptures(fitted, term)) ||
        !isLearnedGiven(fitted, term, 0, canImitate)) {
      continue;
    }
    if (const Term* const imitator = findImitator(fitted.model, fitted.fit, term)) {
      held.emplace(term.first, imitator);
    }
  }
  return held;
}

std::vector<Finding> listUndetermined(const FittedModel& fitted, const HeldOffsets& held) {
  std::vector<Finding> findings;
  if (auto still = describeStillJoints(fitted)) {
    findings.push_back(*std::move(still));
  }
  for (const Term& term : fitted.model.terms()) {
    if (!isAsked(term)) {
      continue;
    }
    if (!isOffset(term)) {
      if (auto finding = describeEffect(fitted, term)) {
        findings.push_back(*std::move(finding));
      }
    } else if (!isLearned(fitted, term.first) && !held.contains(term.first) &&
               !isStill(term.placeIndex, fitted.measurements)) {
      findings.push_back(describeOffset(fitted, term));
    }
  }
  return findings;
}

std::optional<Finding> describeStillJoints(const FittedModel& fitted) {
  std::vector<std::string> words, names;
  bool isUnknown = false;
  for (const Term& term : fitted.model.terms()) {
    if (isOffset(term) && isAsked(term) && isStill(term.placeIndex, fitted.measurements)) {
      words.push_back(describeUnknown(term, 0));
      names.push_back(term.placeName);
      isUnknown |= !isLearned(fitted, term.first);
    }
  }
  if (!isUnknown) {
    return std::nullopt;
  }
  const bool single = words.size() == 1;
  Finding finding =
      makeFinding("not-learned", fmt::format("jointOffset@{}", fmt::join(names, ",")), FindingLevel::stop,
                  fmt::format("{} joint{} never moved: {}; without motion no offset can be learned: add poses that "
                              "move {}, or leave {} out",
                              words.size(), single ? "" : "s", joinWords(words), single ? "it" : "them",
                              single ? "its offset" : "their offsets"),
                  fitted.measurements);
  finding.answers = {{"take poses", "", ""}};
  for (const std::string& name : names) {
    finding.answers.push_back({"leave out", "effect", fmt::format("{}@{}", effectName::jointOffset, name)});
  }
  return finding;
}

std::string formatSigma(const Term& offset, double sigma) {
  const auto [unit, factor] = displayUnit(offset.effect.unknowns.front().unit);
  return appendUnit(fmt::format("{:.1f}", factor * sigma), unit);
}

} // namespace naocal
