#include "calibration/ModelUncertainty.hpp"

#include "calibration/ReadingNoise.hpp"
#include "calibration/result/Wording.hpp"
#include "estimation/CandidateTerms.hpp"
#include "estimation/Model.hpp"
#include "estimation/ModelBuilder.hpp"
#include "inference/DriverBasis.hpp"
#include "inference/Evidence.hpp"
#include "inference/Thresholds.hpp"
#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

namespace naocal {

namespace {

/// Whether the wide prior is more likely for all of an effect's unknowns together. `values`, `variances`: posterior
/// under the narrow prior, in units of its sigmas.
///   -2 ln likelihood(w) = sum ln(1 + w^2 V) - s^2 / (V + w^-2),   V the data's information, s their score at zero
bool isWide(const Eigen::ArrayXd& values, const Eigen::ArrayXd& variances) {
  const Eigen::ArrayXd information = (1 / variances - 1).max(0), scores = values / variances;
  const auto cost = [&](const PriorWidth& prior) {
    const double square = prior.width * prior.width;
    return ((square * information).log1p() - scores.square() / (information + 1 / square)).sum() -
           2 * std::log(prior.odds);
  };
  return cost(widestWidth) < cost(usualWidth);
}

FittedPoint pointOf(const Fit& fit) {
  return {fit.minimum.state, fit.noise, fit.loss};
}

/// The named effects of an explanation.
std::vector<Term> namedEffects(const WideModel& wide, const WindowModel& explanation) {
  std::vector<Term> result;
  for (const WindowMember& member : explanation.members) {
    if (member.group < wide.candidates().size()) {
      result.push_back(wide.candidates()[member.group]);
    }
  }
  std::sort(result.begin(), result.end(), [](const Term& a, const Term& b) { return a.label() < b.label(); });
  return result;
}

/// Whether the effect acts on a joint angle, as joint noise does.
bool isOfJoint(const Term& term) {
  return term.effect.placeKind == PlaceKind::motor || term.effect.placeKind == PlaceKind::joint;
}

bool areSame(const std::vector<Term>& a, const std::vector<Term>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Term& one, const Term& other) { return one.label() == other.label(); });
}

/// `first`, followed by the other candidates, so that a model's effects come first.
std::vector<Term> putInFront(const std::vector<Term>& first, const std::vector<Term>& candidates) {
  std::vector<Term> result = first;
  for (const Term& term : candidates) {
    if (std::none_of(first.begin(), first.end(), [&](const Term& one) { return one.label() == term.label(); })) {
      result.push_back(term);
    }
  }
  return result;
}

Model without(const Model& model, const std::vector<Term>& effects) {
  Model result;
  for (const Term& term : model.terms()) {
    if (std::none_of(effects.begin(), effects.end(), [&](const Term& one) { return one.label() == term.label(); })) {
      result.add(term);
    }
  }
  return result;
}

/// Start for the fit of a larger model, from a linear explanation in terms of `own` and effects. `along`: the larger
/// model without the effects.
Eigen::VectorXd startOf(const Model& larger, const Model& own, const Model& along, const WideModel& wide,
                        const WindowModel& explanation, const std::vector<Term>& effects) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(eigenIndex(larger.unknownCount()));
  result.head(eigenIndex(along.unknownCount())) = mapParameters(own, explanation.unknowns, along);
  Eigen::Index next = eigenIndex(along.unknownCount());
  for (const Term& effect : effects) {
    Eigen::Index column = 0;
    for (const WindowMember& member : explanation.members) {
      if (member.group < wide.candidates().size() && wide.candidates()[member.group].label() == effect.label()) {
        result.segment(next, member.count) = explanation.sizes.segment(column, member.count);
      }
      column += member.count;
    }
    next += eigenIndex(effect.effect.unknowns.size());
  }
  return result;
}

/// Marks effects that may differ between readings of one pose: by their drivers, not by the posture.
std::vector<bool> markVarying(const std::vector<Term>& terms) {
  std::vector<bool> result;
  for (const Term& term : terms) {
    result.push_back(anyDriver(term.effect, std::not_fn(followsFromAngles)));
  }
  return result;
}

/// The likeliest effect or curve, if it is beyond chance and does not matter.
std::optional<NegligibleEffect> describeNegligible(const WideModel& wide, const Robot& robot,
                                                   const Evidence& evidence) {
  if (evidence.pValue > threshold::alarm || evidence.matters || !evidence.likeliest) {
    return std::nullopt;
  }
  const std::size_t group = *evidence.likeliest;
  const GroupEvidence& found = evidence.groups[group];
  const bool isNamed = group < wide.candidates().size();
  return NegligibleEffect{formatGroup(wide, robot, group),
                          isNamed ? formatSizes(wide.candidates()[group].effect, found.estimate, found.covariance)
                                  : std::string{},
                          found.movedPx};
}

/// Steps from fit to fit towards the likeliest explanation.
class ExplanationSearch {
public:
  ExplanationSearch(const Measurements& measurements, const Model& model, const std::optional<RepeatInfo>& repeats,
                    const CalibrationOptions& options)
      : measurements_{measurements}, added_{addedEffects(model)}, base_{without(model, added_)}, repeats_{repeats},
        options_{options}, candidates_{testableTerms(measurements, model, options.effects)} {}

  const std::vector<Term>& added() const { return added_; }
  const Model& base() const { return base_; }

  /// Joint noise levels under the widest model, linearised at a fit of `own` with these effects.
  NoiseLevels levelsAt(const Model& own, const std::vector<Term>& effects, const Fit& fit, const Noise& noise) const {
    if (!repeats_) {
      return {noise, {}};
    }
    const WideModel wide{measurements_, own, putInFront(effects, candidates_), pointOf(fit), false};
    return estimateNoiseLevels(wide.problem(), noise, *repeats_, markVarying(wide.candidates()));
  }
  /// Fit accurate enough to linearise at. Keeps a quadratic loss.
  Fit refineNearly(const Model& model, const Noise& noise, Fit from) const {
    const bool isRobust = from.loss.scale > 0;
    return isRobust ? fitRobustly(measurements_, model, noise, std::move(from))
                    : refit(measurements_, model, noise, Loss{}, std::move(from), coarseTolerance);
  }
  std::shared_ptr<const WideModel> wideAt(const Model& own, const std::vector<Term>& effects, const Fit& fit) const {
    return std::make_shared<const WideModel>(measurements_, own, putInFront(effects, candidates_), pointOf(fit), true);
  }

  /// One step: fits the effects of the window's likeliest explanation. Returns false if they equal those already fitted
  /// or the linear explanation is infeasible.
  bool extend(const WideModel& wide, const Model& own, MissingEffectAnalysis& explained) const {
    const WindowModel& likeliest = explained.window.models.front();
    const std::vector<Term> effects = namedEffects(wide, likeliest);
    if (areSame(effects, explained.effects)) {
      return false;
    }
    const Model along = withWeighingOffsets(measurements_, base_, effects);
    Model larger = with(along, effects);
    Fit from{Noise{.encoder = -1}, explained.largerFit.loss, {}, explained.largerFit.restartsChanged};
    from.minimum.state.unknowns = startOf(larger, own, along, wide, likeliest, effects);
    const Noise& noise = explained.levels.noise;
    try {
      from = refit(measurements_, larger, noise, from.loss, std::move(from), coarseTolerance);
      larger = widenPriors(larger, from).value_or(larger);
      from = refineNearly(larger, noise, std::move(from));
    } catch (const InputError&) {
      return false;
    }
    explained.effects = effects;
    explained.larger = larger;
    const Noise reread = estimateReadingNoise(measurements_, larger, from, noise, options_.effects);
    explained.levels = levelsAt(along, effects, from, reread);
    explained.largerFit = refineNearly(larger, explained.levels.noise, std::move(from));
    return true;
  }

  /// Steps to the window of the likeliest explanation.
  void explain(MissingEffectAnalysis& explained) const {
    constexpr int most = 3; // steps
    for (int step = 0; step <= most; ++step) {
      explained.own = withWeighingOffsets(measurements_, base_, explained.effects);
      explained.wide = wideAt(explained.own, explained.effects, explained.largerFit);
      const WideModel& wide = *explained.wide;
      explained.window = searchModelWindow({wide.problem(), explained.levels.noise}, added_.size());
      explained.names.clear();
      for (std::size_t group = 0; group < wide.problem().groups.size(); ++group) {
        explained.names.push_back(formatGroup(wide, measurements_.robot, group));
      }
      if (step == most || !extend(wide, explained.own, explained)) {
        return;
      }
    }
  }

  /// Starts from the requested model, with user-added effects moved to the end, and its fit.
  void startAt(const Model& model, const Fit& fit, MissingEffectAnalysis& explained) const {
    explained.effects = added_;
    explained.larger = with(withWeighingOffsets(measurements_, base_, added_), added_);
    Fit from = fit;
    from.minimum.state.unknowns = mapParameters(model, fit.minimum.state.unknowns, explained.larger);
    explained.largerFit = refineNearly(explained.larger, explained.levels.noise, std::move(from));
  }

private:
  static Model with(Model model, const std::vector<Term>& effects) {
    for (const Term& effect : effects) {
      model.add(effect);
    }
    return model;
  }

  const Measurements& measurements_;
  std::vector<Term> added_;
  Model base_; // without `added_`
  const std::optional<RepeatInfo>& repeats_;
  const CalibrationOptions& options_;
  std::vector<Term> candidates_;
};

} // namespace

std::string formatGroup(const WideModel& wide, const Robot& robot, std::size_t group) {
  if (group < wide.candidates().size()) {
    return wide.candidates()[group].label();
  }
  const std::size_t curve = group - wide.candidates().size();
  if (curve < wide.mounts().size()) {
    return wide.mounts()[curve].term.placeName;
  }
  const DriverBasis& cell = wide.map().cells[curve - wide.mounts().size()];
  return robot.joints[cell.motor].name + " over " + expressionName(wide.map().drivers[cell.driver], cell.motor);
}

std::vector<Term> addedEffects(const Model& model) {
  std::vector<Term> result;
  std::copy_if(model.terms().begin(), model.terms().end(), std::back_inserter(result),
               [](const Term& term) { return !term.effect.inBaseModel && !term.isPlacement && term.requested; });
  std::sort(result.begin(), result.end(), [](const Term& a, const Term& b) { return a.label() < b.label(); });
  return result;
}

std::optional<Model> widenPriors(const Model& model, const Eigen::VectorXd& unknowns,
                                 const Eigen::VectorXd& variances) {
  Model result;
  bool widened = false;
  for (Term term : model.terms()) {
    const Eigen::ArrayXd sigmas = term.sigmas();
    const auto first = eigenIndex(term.first), count = sigmas.size();
    if (term.requested && !term.isPlacement && !term.effect.inBaseModel &&
        isWide(unknowns.segment(first, count).array() / sigmas,
               variances.segment(first, count).array() / sigmas.square())) {
      for (Unknown& unknown : term.effect.unknowns) {
        unknown.sigma *= widestWidth.width;
      }
      widened = true;
    }
    result.add(std::move(term));
  }
  return widened ? std::optional{std::move(result)} : std::nullopt;
}

std::optional<Model> widenPriors(const Model& model, const Fit& fit) {
  const Eigen::MatrixXd& hessian = fit.minimum.linear.hessian;
  const Eigen::MatrixXd covariance = hessian.ldlt().solve(Eigen::MatrixXd::Identity(hessian.rows(), hessian.cols()));
  return widenPriors(model, fit.minimum.state.unknowns, covariance.diagonal());
}

MissingEffectAnalysis analyseMissingEffects(const Measurements& measurements, const Model& model, const Fit& fit,
                                            const Noise& noise, const std::optional<RepeatInfo>& repeats,
                                            const CalibrationOptions& options) {
  const ExplanationSearch search{measurements, model, repeats, options};
  MissingEffectAnalysis result{search.levelsAt(model, {}, fit, noise), fit, {}, model, fit, model, {}, {}, {}};
  result.fit = result.largerFit = search.refineNearly(model, result.levels.noise, fit);
  if (!search.added().empty()) {
    search.startAt(model, result.fit, result);
  }
  search.explain(result);
  if (options.robust && result.largerFit.loss.scale == 0) { // what the explanation leaves far off are accidents
    result.largerFit = fitRobustly(measurements, result.larger, result.levels.noise, std::move(result.largerFit));
    search.explain(result);
  }
  return result;
}

bool MissingEffectAnalysis::lacksMoreThanScatter() const {
  return levels.noise.pose < suspectScatter &&
         std::any_of(effects.begin(), effects.end(), [](const Term& term) { return !isOfJoint(term); });
}

double describe(const Measurements& measurements, const MissingEffectAnalysis& explained) {
  constexpr double detectorTail = 0.3; // [px]: errors of corners of printed boards
  const Noise& noise = explained.levels.noise;
  const Loss accidents{measurements.cornerCount > 0 ? std::max(1.0, detectorTail / noise.pixel) : 1};
  const Fit fit = refit(measurements, explained.larger, noise, accidents, explained.largerFit, comparisonTolerance);
  const Residuals::Linear& linear = fit.minimum.linear;
  double result = 2 * linear.cost + logDeterminant(Eigen::LLT<Eigen::MatrixXd>{linear.hessian}) +
                  2 * explained.larger.sigmas().array().log().sum() + poseNoisePenalty(noise.pose) -
                  explained.window.unnamedGain;
  for (const MarginalSystem& part : linear.eliminated) {
    result += part.inner.rows() > 0 ? logDeterminant(part.inner) : 0;
  }
  result += 2 * static_cast<double>(explained.effects.size()) *
            std::log(std::max<double>(1, static_cast<double>(explained.names.size())));
  result += 4 * static_cast<double>(measurements.cornerCount) * std::log(noise.pixel);
  return result + logNoiseOfReadings(measurements, noise);
}

void fillCompleteness(const CandidateTests& tests, const Robot& robot, CalibrationResult& result) {
  result.pValue = tests.evidence().pValue;
  result.matters = tests.evidence().matters;
  result.negligible = describeNegligible(tests.wide(), robot, tests.evidence());
}

} // namespace naocal
