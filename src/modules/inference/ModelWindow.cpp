#include "inference/ModelWindow.hpp"

#include "inference/Evidence.hpp"
#include "inference/OwnEstimates.hpp"
#include "inference/PoseMisfit.hpp"
#include "inference/Thresholds.hpp"
#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Statistics.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace naocal {

namespace {

constexpr double leastWeight = 1e-5; // relative to the likeliest model: a shoulder at 0.0005 is known to 2 %

using Members = std::vector<WindowMember>;

/// The linearised problem at one noise level, as needed for the cost and the estimates of any model. Coefficients and
/// scores are in units of `plausible`, linearised about zero coefficients.
class Window {
public:
  /// Models consist of the problem's first `groups` groups, without those `excluded`.
  Window(const MeasuredTests& measured, std::size_t groups, std::size_t expected = 0,
         std::set<std::size_t> excluded = {})
      : problem_{measured.alone.problem()}, groups_{groups}, expected_{expected}, excluded_{std::move(excluded)},
        alone_{measured.alone}, tests_{measured.tests}, own_{measured.outcome.own} {
    scoreAtFit_ = score_ = problem_.plausible.cwiseProduct(measured.scores);
    scaled_ = pull_ = Eigen::VectorXd::Zero(score_.size());
    if (problem_.sizes.size() > 0) {
      moveToZero();
    }
    countGroups();
  }

  /// A model with its cost, mixed over its choices of plausible widths; without estimates.
  WindowModel model(const Members& members) {
    const std::vector<WindowModel> all = modelsOfEveryWidth(members);
    const double least = leastCost(all);
    double sum = 0;
    for (const WindowModel& one : all) {
      sum += std::exp((least - one.cost) / 2);
    }
    return {.members = members, .cost = least - 2 * std::log(sum)};
  }
  /// The model once for each choice of its members' plausible widths, without estimates. Each effect has a width of
  /// its own: an effect with one large unknown probably has other large ones, which says nothing about other effects.
  /// If two members are numerically identical, the factorisation fails and the model gets no weight.
  std::vector<WindowModel> modelsOfEveryWidth(const Members& members) {
    const std::vector<Eigen::Index> columns = columnsOf(members);
    const Eigen::MatrixXd information = informationOf(members, eigenIndex(columns.size()));
    const Eigen::VectorXd score = score_(columns);
    const double prior = priorCost(members);
    std::vector<WindowModel> result;
    for (const std::vector<PriorWidth>& widths : widthChoices(members)) {
      WindowModel& one = result.emplace_back(WindowModel{.members = members, .cost = prior});
      for (std::size_t i = 0; i < members.size(); ++i) {
        one.widths.push_back(widths[i].width);
        one.cost +=
            2 * static_cast<double>(members[i].count) * std::log(widths[i].width) - 2 * std::log(widths[i].odds);
      }
      const Eigen::LLT<Eigen::MatrixXd> factor{posteriorPrecision(one, information)};
      one.cost = factor.info() == Eigen::Success
                     ? one.cost + 2 * factor.matrixLLT().diagonal().array().log().sum() - score.dot(factor.solve(score))
                     : std::numeric_limits<double>::max();
    }
    return result;
  }
  /// Misfit between poses of a model with its members: chi2 and its degrees of freedom. `atFit`: of the model alone.
  PoseMisfit misfitOf(const WindowModel& model, const PoseMisfit& atFit) {
    PoseMisfit result{.chi2 = atFit.chi2 + fromFitToZero_, .freedom = atFit.freedom};
    const std::vector<Eigen::Index> columns = columnsOf(model.members);
    if (!columns.empty()) {
      const auto count = eigenIndex(columns.size());
      const Eigen::MatrixXd information = informationOf(model.members, count);
      const Eigen::VectorXd score = score_(columns);
      const Eigen::LLT<Eigen::MatrixXd> factor{posteriorPrecision(model, information)};
      const Eigen::VectorXd sizes = factor.solve(score);
      result.chi2 += sizes.dot(information * sizes) - 2 * score.dot(sizes);
      result.freedom -= factor.solve(information).trace();
    }
    return {.chi2 = std::max(0.0, result.chi2), .freedom = std::max(1.0, result.freedom)};
  }
  /// The own unknowns under any model, at a misfit.
  OwnEstimates estimatesAt(double misfit) const {
    std::optional<ScoreProblem> without;
    std::optional<NullModel> plain;
    if (problem_.plain != nullptr) {
      without.emplace(*problem_.plain, none_, problem_.unknowns, problem_.sigmas, 0);
      plain.emplace(*without, alone_.noise());
    }
    return OwnEstimates{{.alone = alone_,
                         .explained = tests_.explainedInformation() * problem_.plausible.asDiagonal(),
                         .own = own_,
                         .score = scoreAtFit_,
                         .sizes = scaled_,
                         .pull = pull_,
                         .plain = plain ? &*plain : nullptr},
                        misfit};
  }
  /// Adds estimates to a model that has only its cost.
  void estimate(const OwnEstimates& estimates, WindowModel& model) {
    const std::vector<Eigen::Index> columns = columnsOf(model.members);
    const auto count = eigenIndex(columns.size());
    OwnEstimate own = estimates.estimate(columns, informationOf(model.members, count), widthsPerColumn(model));
    model.unknowns = std::move(own.value);
    model.spread = std::move(own.spread);
    model.sizes = problem_.plausible(columns).cwiseProduct(own.coefficients);
    model.sizeSpread = problem_.plausible(columns).asDiagonal() * own.coefficientSpread;
    model.columns = columns;
  }

  /// What each named effect that a model lacks does to the own unknowns where it stays unnoticed.
  std::vector<UndetectedEffect> listUndetected(const OwnEstimates& estimates, const WindowModel& model) {
    std::vector<UndetectedEffect> result;
    const Eigen::VectorXd widths = widthsPerColumn(model);
    const double alarm = threshold::alarm / named_;
    for (std::size_t group = 0; group < problem_.named; ++group) {
      Members members = model.members;
      members.push_back({group, problem_.groups[group].count});
      const std::vector<Eigen::Index> columns = columnsOf(members);
      if (!isMember(model, group)) {
        const double noticed =
            requiredNoncentrality(threshold::power, static_cast<double>(members.back().count), alarm);
        UnnoticedBiases unnoticed =
            estimates.findUnnoticed(columns, informationOf(members, eigenIndex(columns.size())), widths, noticed);
        const ColumnGroup& own = problem_.groups[group];
        result.push_back({group, std::move(unnoticed.own),
                          problem_.plausible.segment(own.first, own.count).asDiagonal() * unnoticed.coefficients,
                          problem_.plausible(columnsOf(model.members)).asDiagonal() * unnoticed.taken});
      }
    }
    return result;
  }

  /// False where squares of the residuals overflow.
  bool isFinite() const { return score_.allFinite() && own_.allFinite(); }
  std::size_t groups() const { return groups_; }
  bool allows(std::size_t group) const { return excluded_.count(group) == 0; }
  /// Admissible column counts of a group: all columns, or one choice per degree of a smooth curve.
  std::vector<WindowMember> choices(std::size_t group) const {
    const ColumnGroup& columns = problem_.groups[group];
    std::vector<WindowMember> result;
    for (Eigen::Index count = columns.part > 0 ? columns.part : columns.count; count <= columns.count;
         count += std::max<Eigen::Index>(columns.part, columns.count - count + 1)) {
      result.push_back({group, count});
    }
    return result;
  }
  /// Cost of the effects with nonzero sizes at the linearisation point, relative to it, without what another size of
  /// theirs would gain.
  double costAsFitted() { return fromFitToZero_ + model(fitted_).cost + computeRefitGain(); }
  /// Increase of -2 ln likelihood of the model alone from the linearisation point to zero coefficients.
  double fromFitToZero() const { return fromFitToZero_; }

private:
  static double leastCost(const std::vector<WindowModel>& models) {
    double least = std::numeric_limits<double>::infinity();
    for (const WindowModel& one : models) {
      least = std::min(least, one.cost);
    }
    return least;
  }
  static bool isMember(const WindowModel& model, std::size_t group) {
    return std::any_of(model.members.begin(), model.members.end(),
                       [&](const WindowMember& one) { return one.group == group; });
  }
  static Eigen::VectorXd widthsPerColumn(const WindowModel& model) {
    std::vector<double> widths;
    for (std::size_t i = 0; i < model.members.size(); ++i) {
      widths.insert(widths.end(), static_cast<std::size_t>(model.members[i].count), model.widths[i]);
    }
    return Eigen::Map<const Eigen::VectorXd>(widths.data(), eigenIndex(widths.size()));
  }
  /// Posterior precision of the members' sizes, in units of what is plausible: information + 1 / width^2.
  static Eigen::MatrixXd posteriorPrecision(const WindowModel& model, Eigen::MatrixXd information) {
    information.diagonal() += widthsPerColumn(model).cwiseAbs2().cwiseInverse();
    return information;
  }
  /// Each width of the last member with each choice for the others that is likely without it: all choices would be
  /// exponential in the members.
  std::vector<std::vector<PriorWidth>> widthChoices(const Members& members) {
    if (members.empty()) {
      return {{}};
    }
    std::vector<std::vector<PriorWidth>> result;
    for (const std::vector<PriorWidth>& others : likelyWidths({members.begin(), members.end() - 1})) {
      for (const PriorWidth& width : plausibleWidths) {
        result.push_back(others);
        result.back().push_back(width);
      }
    }
    return result;
  }
  /// Choices of widths with at least `leastWeight` beside the likeliest one, cached per members.
  const std::vector<std::vector<PriorWidth>>& likelyWidths(const Members& members) {
    auto [entry, isNew] = likelyWidths_.try_emplace(members);
    if (isNew) {
      const std::vector<std::vector<PriorWidth>> choices = widthChoices(members);
      const std::vector<WindowModel> models = modelsOfEveryWidth(members);
      const double least = leastCost(models);
      for (std::size_t i = 0; i < choices.size(); ++i) {
        if (models[i].cost <= least - 2 * std::log(leastWeight)) {
          entry->second.push_back(choices[i]);
        }
      }
    }
    return entry->second;
  }
  std::vector<Eigen::Index> columnsOf(const Members& members) const {
    std::vector<Eigen::Index> columns;
    for (const WindowMember& member : members) {
      for (Eigen::Index k = 0; k < member.count; ++k) {
        columns.push_back(problem_.groups[member.group].first + k);
      }
    }
    return columns;
  }
  /// Information of a model's first `count` columns. Only members other than the last need the full information of
  /// their columns.
  Eigen::MatrixXd informationOf(const Members& members, Eigen::Index count) {
    Eigen::MatrixXd result(count, count);
    Eigen::Index column = 0;
    for (const WindowMember& member : members) {
      const ColumnGroup& group = problem_.groups[member.group];
      const auto plausible = problem_.plausible.segment(group.first, member.count);
      result.block(column, column, member.count, member.count) =
          plausible.asDiagonal() * tests_.informationOf(member.group).topLeftCorner(member.count, member.count) *
          plausible.asDiagonal();
      Eigen::Index row = 0;
      for (const WindowMember& earlier : members) {
        if (row == column) {
          break;
        }
        const Eigen::MatrixXd between = informationWith(earlier).middleRows(group.first, member.count);
        result.block(column, row, member.count, earlier.count) = between;
        result.block(row, column, earlier.count, member.count) = between.transpose();
        row += earlier.count;
      }
      column += member.count;
    }
    return result;
  }
  /// Information of all columns (rows) with a member's columns, cached per group.
  Eigen::Ref<const Eigen::MatrixXd> informationWith(const WindowMember& member) {
    auto [entry, isNew] = known_.try_emplace(member.group);
    if (isNew) {
      const ColumnGroup& group = problem_.groups[member.group];
      entry->second = problem_.plausible.asDiagonal() * tests_.informationWith(member.group, group.count) *
                      problem_.plausible.segment(group.first, group.count).asDiagonal();
    }
    return entry->second.leftCols(member.count);
  }
  /// Moves the linearisation to zero coefficients of all candidates.
  void moveToZero() {
    for (std::size_t group = 0; group < problem_.named; ++group) {
      const ColumnGroup& columns = problem_.groups[group];
      const Eigen::VectorXd own = problem_.sizes.segment(columns.first, columns.count);
      if (own.isZero(0)) {
        continue;
      }
      const Eigen::VectorXd scaled = own.cwiseQuotient(problem_.plausible.segment(columns.first, columns.count));
      const Eigen::VectorXd pull = informationWith({group, columns.count}) * scaled;
      fromFitToZero_ += 2 * score_.segment(columns.first, columns.count).dot(scaled) +
                        scaled.dot(pull.segment(columns.first, columns.count));
      score_ += pull;
      pull_ += pull;
      scaled_.segment(columns.first, columns.count) = scaled;
      fitted_.push_back({group, columns.count});
    }
  }
  /// Decrease of -2 ln posterior from the fitted sizes to the best ones at this noise level.
  double computeRefitGain() {
    if (fitted_.empty()) {
      return 0;
    }
    const std::vector<Eigen::Index> columns = columnsOf(fitted_);
    WindowModel widest{.members = fitted_};
    widest.widths.assign(fitted_.size(), widestWidth.width);
    const Eigen::MatrixXd precision = posteriorPrecision(widest, informationOf(fitted_, eigenIndex(columns.size())));
    const Eigen::VectorXd score = scoreAtFit_(columns);
    return score.dot(precision.ldlt().solve(score));
  }
  void countGroups() {
    named_ = std::max<double>(1, static_cast<double>(problem_.named));
    curves_ = std::max<double>(1, static_cast<double>(problem_.groups.size() - problem_.named));
  }
  /// -2 ln(prior probability) of these members.
  double priorCost(const Members& members) const {
    double cost = 0;
    std::size_t named = 0;
    for (const WindowMember& member : members) {
      const double degrees = static_cast<double>(choices(member.group).size());
      if (member.group >= problem_.named) {
        cost += 2 * std::log(curves_ * degrees) + threshold::unnamed;
      } else if (++named > expected_) {
        cost += 2 * std::log(named_);
      }
    }
    return cost;
  }

  const ScoreProblem& problem_;
  std::size_t groups_, expected_;
  std::set<std::size_t> excluded_;
  const NullModel& alone_;
  const ScoreTest& tests_;
  DriverColumns none_{.blocks = std::vector<std::vector<DriverColumns::Block>>(problem_.poses->size())};
  Eigen::VectorXd own_, score_, scoreAtFit_;
  Eigen::VectorXd scaled_, pull_; // coefficients at the linearisation point, and their information times them
  Members fitted_;
  double fromFitToZero_ = 0, named_ = 1, curves_ = 1;
  std::map<std::size_t, Eigen::MatrixXd> known_;
  std::map<Members, std::vector<std::vector<PriorWidth>>> likelyWidths_;
};

bool hasGroup(const Members& members, std::size_t group) {
  return std::any_of(members.begin(), members.end(), [&](const WindowMember& one) { return one.group == group; });
}

Members removeMember(Members members, std::size_t place) {
  members.erase(members.begin() + static_cast<std::ptrdiff_t>(place));
  return members;
}

/// Visits each extension of `members` by one group, at the degree of lowest cost.
template <class Visit> void visitAdditions(Window& window, const Members& members, const Visit& visit) {
  for (std::size_t group = 0; group < window.groups(); ++group) {
    if (!window.allows(group) || hasGroup(members, group)) {
      continue;
    }
    std::optional<WindowModel> best;
    for (const WindowMember& choice : window.choices(group)) {
      Members larger = members;
      larger.push_back(choice);
      WindowModel model = window.model(larger);
      if (!best || model.cost < best->cost) {
        best = std::move(model);
      }
    }
    visit(*std::move(best));
  }
}

/// Stepwise search: adds the group that lowers the cost most, then drops members whose removal does not raise it.
WindowModel findLikeliest(Window& window) {
  WindowModel best = window.model({});
  while (best.members.size() < mostMembers) {
    std::optional<WindowModel> next;
    visitAdditions(window, best.members, [&](WindowModel larger) {
      if (larger.cost < best.cost && (!next || larger.cost < next->cost)) {
        next = std::move(larger);
      }
    });
    if (!next) {
      break;
    }
    best = *std::move(next);
    for (std::size_t i = 0; i + 1 < best.members.size();) {
      WindowModel smaller = window.model(removeMember(best.members, i));
      if (smaller.cost <= best.cost) {
        best = std::move(smaller);
        i = 0;
      } else {
        ++i;
      }
    }
  }
  return best;
}

/// The model and all its neighbours: removals, swaps and additions.
std::vector<WindowModel> findNeighbours(Window& window, const WindowModel& best) {
  std::vector<WindowModel> result{best};
  for (std::size_t i = 0; i < best.members.size(); ++i) {
    const Members smaller = removeMember(best.members, i);
    result.push_back(window.model(smaller));
    visitAdditions(window, smaller, [&](WindowModel swapped) {
      if (!hasGroup(best.members, swapped.members.back().group)) {
        result.push_back(std::move(swapped));
      }
    });
  }
  if (best.members.size() < mostMembers) {
    visitAdditions(window, best.members, [&](WindowModel larger) { result.push_back(std::move(larger)); });
  }
  return result;
}

bool isLikelier(const WindowModel& a, const WindowModel& b) {
  return a.cost < b.cost;
}

/// The model and its neighbours with every choice of widths, likeliest first, without estimates. Costs count less where
/// nothing explains the misfit, so the window is wider there; beyond `threshold::bearableMisfit` it grows no further,
/// as nothing rests on such a result.
std::vector<WindowModel> listModels(Window& window, const WindowModel& best, const PoseMisfit& atFit) {
  std::vector<WindowModel> result = window.modelsOfEveryWidth(best.members);
  const PoseMisfit misfit = window.misfitOf(*std::min_element(result.begin(), result.end(), isLikelier), atFit);
  const double most =
      best.cost - 2 * std::log(leastWeight) * std::clamp(misfit.chi2 / misfit.freedom, 1.0, threshold::bearableMisfit);
  for (const WindowModel& model : findNeighbours(window, best)) {
    if (model.cost < most && model.members != best.members) {
      std::vector<WindowModel> models = window.modelsOfEveryWidth(model.members);
      std::move(models.begin(), models.end(), std::back_inserter(result));
    }
  }
  std::sort(result.begin(), result.end(), isLikelier);
  std::erase_if(result, [&](const WindowModel& model) { return model.cost > std::max(most, result.front().cost); });
  return result;
}

/// Fills the weights: exp(-cost / (2 misfit)), their sum 1. Drops what is below `leastWeight`.
void weigh(ModelWindow& window) {
  const double least = window.models.front().cost;
  for (WindowModel& model : window.models) {
    model.weight = std::exp((least - model.cost) / (2 * window.misfit));
  }
  std::erase_if(window.models, [](const WindowModel& model) { return model.weight < leastWeight; });
  const double kept = std::accumulate(window.models.begin(), window.models.end(), 0.0,
                                      [](double all, const WindowModel& model) { return all + model.weight; });
  for (WindowModel& model : window.models) {
    model.weight /= kept;
  }
}

/// Throws InputError for costs or estimates of measurements that are so far from every prediction that sums of their
/// squares overflow.
void requireFinite(bool isFinite) {
  if (!isFinite) {
    throw InputError{"the misfit is no finite number: these captures do not belong together; look for boards whose "
                     "corners all lie at one point, and for huge values"};
  }
}

} // namespace

ExplanationCosts costExplanations(const MeasuredTests& measured) {
  Window window{measured, measured.alone.problem().groups.size()};
  return {window.costAsFitted(), window.fromFitToZero() + findLikeliest(window).cost};
}

std::vector<LikelyEffects> listLikelyEffects(const MeasuredTests& measured, const std::set<std::size_t>& excluded) {
  Window window{measured, measured.alone.problem().named, 0, excluded};
  std::vector<WindowModel> models = findNeighbours(window, findLikeliest(window));
  const double none = window.model({}).cost;
  std::erase_if(models, [&](const WindowModel& model) { return !(model.cost < none); });
  std::stable_sort(models.begin(), models.end(), isLikelier);
  std::vector<LikelyEffects> result;
  for (const WindowModel& model : models) {
    LikelyEffects& effects = result.emplace_back();
    effects.evidence = none - model.cost;
    std::transform(model.members.begin(), model.members.end(), std::back_inserter(effects.groups),
                   [](const WindowMember& member) { return member.group; });
    std::sort(effects.groups.begin(), effects.groups.end());
  }
  return result;
}

ModelWindow searchModelWindow(const MeasuredTests& measured, std::size_t expected) {
  const ScoreProblem& problem = measured.alone.problem();
  Window window{measured, problem.groups.size(), expected};
  const WindowModel likeliest = findLikeliest(window);
  const PoseMisfit atFit = testPoseMisfit(problem, measured.alone.noise());
  requireFinite(window.isFinite() && std::isfinite(atFit.within) && std::isfinite(likeliest.cost));
  Members effects = likeliest.members;
  std::erase_if(effects, [&](const WindowMember& member) { return member.group >= problem.named; });
  ModelWindow result{.models = listModels(window, likeliest, atFit),
                     .unnamedGain = window.model(effects).cost - likeliest.cost};
  const PoseMisfit misfit = window.misfitOf(result.models.front(), atFit);
  result.misfit = std::max(1.0, misfit.chi2 / misfit.freedom);
  result.freedom = misfit.freedom;
  weigh(result);
  const OwnEstimates estimates = window.estimatesAt(result.misfit);
  result.covariance = estimates.covariance();
  result.mean = Eigen::VectorXd::Zero(problem.ownCount());
  result.groupWeights.assign(problem.groups.size(), 0);
  for (WindowModel& model : result.models) {
    window.estimate(estimates, model);
    result.mean += model.weight * model.unknowns;
    for (const WindowMember& member : model.members) {
      result.groupWeights[member.group] += model.weight;
    }
  }
  result.variance = result.covariance.diagonal();
  for (const WindowModel& model : result.models) {
    result.variance +=
        model.weight * (model.spread.rowwise().squaredNorm() + (model.unknowns - result.mean).cwiseAbs2());
  }
  requireFinite(result.mean.allFinite() && result.variance.allFinite());
  result.undetected = window.listUndetected(estimates, result.models.front());
  return result;
}

std::vector<StudentMixture::Part> ModelWindow::along(const Eigen::VectorXd& own, const Eigen::VectorXd& columns) const {
  const double alone = own.dot(covariance * own);
  std::vector<StudentMixture::Part> result;
  for (const WindowModel& model : models) {
    Eigen::VectorXd spread = model.spread.transpose() * own;
    double value = own.dot(model.unknowns);
    if (!model.columns.empty()) {
      const Eigen::VectorXd slopes = columns(model.columns);
      spread += model.sizeSpread.transpose() * slopes;
      value += slopes.dot(model.sizes);
    }
    result.push_back({model.weight, value, std::sqrt(std::max(0.0, alone + spread.squaredNorm()))});
  }
  return result;
}

} // namespace naocal
