#include "poses/CapturePlan.hpp"

#include "calibration/Fit.hpp"
#include "calibration/result/Wording.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "robot/RobotOfSet.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

/// Share of the plausible size that all candidates together may leave of a target; above it, the plausible sizes of
/// others tell it rather than the candidates.
constexpr double mostUntold = 0.25;

/// An unknown of a model.
struct UnknownOfTerm {
  const Term* term;
  std::size_t number; // within the term

  const Unknown& unknown() const { return term->effect.unknowns[number]; }
  Eigen::Index index() const { return eigenIndex(term->first + number); }
  bool isOffset() const { return term->effect.name == effectName::jointOffset; }
  bool isMount() const { return term->effect.placeKind == PlaceKind::camera && term->effect.inBaseModel; }
  std::string name() const { return isOffset() ? term->placeName : term->label() + ' ' + unknown().name; }
  /// In a sentence.
  std::string describe() const {
    return term->isPlacement || term->effect.name == effectName::linkGeometry ? describeImitator(*term)
                                                                              : describeUnknown(*term, number);
  }
};

std::vector<UnknownOfTerm> listUnknowns(const Model& model) {
  std::vector<UnknownOfTerm> result;
  for (const Term& term : model.terms()) {
    for (std::size_t i = 0; i < term.effect.unknowns.size(); ++i) {
      result.push_back({&term, i});
    }
  }
  return result;
}

/// Whether poses are planned for an unknown: it is no placement, and no offset that only moves mass.
bool isWanted(const UnknownOfTerm& each) {
  return !each.term->isPlacement && each.term->requested;
}

Eigen::MatrixXd invert(const Eigen::MatrixXd& information) {
  return information.llt().solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
}

/// Why all candidates together do not tell an unknown.
std::string explainUntold(const UnknownOfTerm& untold, const std::vector<UnknownOfTerm>& all,
                          const Eigen::MatrixXd& covariance) {
  constexpr double alike = 0.7; // correlation, above it one unknown does what the other does
  const UnknownOfTerm* imitator = nullptr;
  double most = alike;
  for (const UnknownOfTerm& other : all) {
    const double share =
        std::abs(covariance(untold.index(), other.index())) /
        std::sqrt(covariance(untold.index(), untold.index()) * covariance(other.index(), other.index()));
    if (other.index() != untold.index() && share > most) {
      most = share;
      imitator = &other;
    }
  }
  return imitator ? "cannot be told from " + imitator->describe() : "moves next to nothing that is measured";
}

/// Selects among candidates for one set of measurements.
class CapturePlanner {
public:
  CapturePlanner(const CandidateCaptures& candidates, const CapturePlanOptions& options)
      : candidates_{candidates}, options_{options}, robot_{loadRobot(candidates.set)}, measurements_{buildMeasurements(
                                                                                           {candidates.set}, robot_)},
        model_{buildModel(measurements_, options.effects)}, unknowns_{listUnknowns(model_)} {
    const Fit fit = fitInitially(measurements_, model_, candidates.noise, {});
    const PlannedInformation information =
        linearizePlans(measurements_, model_, candidates.noise, fit.minimum.state.unknowns, candidates.poses.size());
    prior_ = information.known;
    for (const PoseInformation& promised : information.promised) {
      parts_.emplace_back(Eigen::MatrixXd::Zero(prior_.rows(), prior_.cols()));
      promised.addTo(parts_.back());
    }
  }
  CapturePlanner(CandidateCaptures&&, const CapturePlanOptions&) = delete;
  CapturePlanner(const CandidateCaptures&, CapturePlanOptions&&) = delete;

  CapturePlan plan() {
    CapturePlan result;
    result.sieve = candidates_.sieve;
    result.isOnSole = candidates_.isOnSole;
    result.boards = candidates_.boards;
    result.options = options_;
    result.noise = candidates_.noise;
    const std::vector<UnknownOfTerm> targets = findTargets(result);
    Eigen::MatrixXd sum = prior_;
    for (const std::size_t chosen : select(targets)) {
      result.poses.push_back(candidates_.poses[chosen]);
      if (!dependsOnApproach(model_)) {
        result.poses.back().approach.setZero();
      }
      sum += parts_[chosen];
    }
    describe(targets, sum, result);
    return result;
  }

private:
  /// The unknowns that the candidates tell; lists the others.
  std::vector<UnknownOfTerm> findTargets(CapturePlan& result) const {
    Eigen::MatrixXd sum = prior_;
    for (const Eigen::MatrixXd& part : parts_) {
      sum += part;
    }
    const Eigen::MatrixXd covariance = invert(sum);
    std::vector<UnknownOfTerm> targets;
    for (const UnknownOfTerm& each : unknowns_) {
      if (!isWanted(each)) {
        continue;
      }
      const double sigma = std::sqrt(covariance(each.index(), each.index()));
      if (sigma <= mostUntold * each.unknown().sigma) {
        targets.push_back(each);
        continue;
      }
      const std::string why = explainUntold(each, unknowns_, covariance);
      if (!each.isOffset() && !each.isMount()) {
        throw InputError{fmt::format("{}: {} in these poses; leave it out of --effects, or measure more of the robot",
                                     each.name(), why)};
      }
      result.untold.push_back({each.name(), why});
    }
    for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
      const std::vector<std::size_t>& used = measurements_.joints;
      if (robot_.joints[joint].motor == joint && std::find(used.begin(), used.end(), joint) == used.end()) {
        result.untold.push_back({robot_.joints[joint].name, "moves nothing that is measured"});
      }
    }
    if (targets.empty()) {
      throw InputError{fmt::format("none of the joint offsets of {} can be told in this scene: {} {}", robot_.model,
                                   result.untold.front().name, result.untold.front().why)};
    }
    return targets;
  }

  /// What counts as much as one radian of an offset [units of the unknown].
  static double scaleOf(const UnknownOfTerm& each) {
    const bool isAngle = each.unknown().unit == "rad" && (each.isOffset() || each.isMount());
    return isAngle ? 1 : each.unknown().sigma / jointOffset().unknowns.front().sigma;
  }

  /// Indices of the candidates with the best value of the criterion, all unknowns other than the targets marginalised.
  std::vector<std::size_t> select(const std::vector<UnknownOfTerm>& targets) const {
    Eigen::VectorXd scales = Eigen::VectorXd::Ones(prior_.rows());
    std::vector<Eigen::Index> aims, others;
    for (const UnknownOfTerm& each : targets) {
      aims.push_back(each.index());
      scales[each.index()] = scaleOf(each);
    }
    for (Eigen::Index i = 0; i < prior_.rows(); ++i) {
      if (std::find(aims.begin(), aims.end(), i) == aims.end()) {
        others.push_back(i);
      }
    }
    const auto scaled = [&](const Eigen::MatrixXd& information) -> Eigen::MatrixXd {
      return scales.asDiagonal() * information * scales.asDiagonal();
    };
    const PoseCriterion judge{scaled(prior_), others, aims, options_.criterion};
    std::vector<Eigen::MatrixXd> blocks;
    for (const Eigen::MatrixXd& part : parts_) {
      blocks.push_back(judge.relevantInformation(scaled(part)));
    }
    return selectPoses(judge, judge.prior(), blocks, options_.count);
  }

  /// Standard deviations for the information of the chosen poses, and what they assume.
  void describe(const std::vector<UnknownOfTerm>& targets, const Eigen::MatrixXd& sum, CapturePlan& result) const {
    const Eigen::MatrixXd covariance = invert(sum);
    std::vector<Eigen::Index> kept;
    for (const UnknownOfTerm& each : targets) {
      if (!each.isMount()) {
        kept.push_back(each.index());
      }
    }
    const Eigen::VectorXd known = invert(sum(kept, kept)).diagonal();
    for (const UnknownOfTerm& each : targets) {
      const double sigma = std::sqrt(covariance(each.index(), each.index()));
      PlannedSigma told{each.name(), each.unknown().unit, sigma, std::nullopt};
      if (!each.isMount()) {
        told.known = std::sqrt(known[std::find(kept.begin(), kept.end(), each.index()) - kept.begin()]);
      }
      (each.isOffset() ? result.offsets : each.isMount() ? result.mounts : result.effects).push_back(std::move(told));
    }
    for (const Term& term : model_.terms()) {
      if (term.isPlacement) {
        result.estimated.push_back(term.label());
      }
    }
  }

  const CandidateCaptures& candidates_;
  const CapturePlanOptions& options_;
  Robot robot_;
  Measurements measurements_;
  Model model_;
  std::vector<UnknownOfTerm> unknowns_;
  Eigen::MatrixXd prior_;
  std::vector<Eigen::MatrixXd> parts_; // information of each candidate
};

} // namespace

CapturePlan planCaptures(const CandidateCaptures& candidates, const CapturePlanOptions& options) {
  if (options.criterion > Criterion::worst) {
    throw InputError{fmt::format("--criterion: expected D, A, E or worst for a robot that is no NAO, found {}",
                                 toString(options.criterion))};
  }
  if (candidates.poses.size() < options.count) {
    throw InputError{fmt::format("expected {} poses that are measured, found {} among {} that were drawn; draw more "
                                 "with --candidates, or ask for fewer",
                                 options.count, candidates.poses.size(), candidates.sieve.generated)};
  }
  return CapturePlanner{candidates, options}.plan();
}

} // namespace naocal
