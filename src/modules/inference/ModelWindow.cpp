#include "inference/ModelWindow.hpp"

#include "inference/Evidence.hpp"
#include "inference/PoseMisfit.hpp"
#include "inference/Thresholds.hpp"
#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Statistics.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace naocal {

namespace {

constexpr std::size_t mostMembers = 4;
constexpr double leastWeight = 1e-3; // relative to the likeliest model

using Members = std::vector<WindowMember>;

/// The linearised problem at one noise level, as needed for the cost and the estimates of any model. Coefficients and
/// scores are in units of `plausible`, linearised about zero coefficients.
class Window {
public:
  Window(const WideModel& wide, const Noise& noise, std::size_t expected)
      : problem_{wide.problem()}, expected_{expected}, alone_{problem_, noise}, tests_{alone_}, misfit_{testPoseMisfit(
                                                                                                    problem_, noise)} {
    const PoseResiduals measured = measuredResiduals(*problem_.poses);
    const Eigen::MatrixXd own = alone_(measured, problem_.priorScore()).own;
    score_ = problem_.plausible.cwiseProduct(tests_.projectedScores(measured, own).col(0));
    const auto& factor = alone_.factor();
    answers_ = factor.matrixU().solve(tests_.explainedInformation()) * problem_.plausible.asDiagonal();
    alone0_ = problem_.unknowns - factor.matrixU().solve(own).col(0);
    variances_ = factor.solve(Eigen::MatrixXd::Identity(problem_.ownCount(), problem_.ownCount())).diagonal();
    moveToZero(wide.sizes());
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
  /// The model once for each choice of its members' plausible widths, with estimates.
  std::vector<WindowModel> modelsByWidth(const Members& members) {
    std::vector<WindowModel> all = modelsOfEveryWidth(members);
    for (WindowModel& one : all) {
      one = estimate(std::move(one));
    }
    return all;
  }

  std::size_t groups() const { return problem_.groups.size(); }
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
  /// False where squares of the residuals overflow.
  bool isFinite() const { return std::isfinite(misfit_.within) && score_.allFinite() && alone0_.allFinite(); }
  double misfitOf(const WindowModel& model) const { return std::max(1.0, model.chi2 / model.freedom); }
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
  /// Posterior precision of the members' sizes, in units of what is plausible: information + 1 / width^2.
  static Eigen::MatrixXd posteriorPrecision(const WindowModel& model, Eigen::MatrixXd information) {
    Eigen::Index column = 0;
    for (std::size_t i = 0; i < model.members.size(); ++i) {
      for (Eigen::Index k = 0; k < model.members[i].count; ++k, ++column) {
        information(column, column) += 1 / (model.widths[i] * model.widths[i]);
      }
    }
    return information;
  }
  /// The model with each of its `widthChoices`, costs only. Each effect has a width of its own: an effect with one
  /// large unknown probably has other large ones, which says nothing about other effects. If two members are
  /// numerically identical, the factorisation fails and the model gets no weight.
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
  /// Adds estimates and misfit to a model that has only its cost.
  WindowModel estimate(WindowModel result) {
    const std::vector<Eigen::Index> columns = columnsOf(result.members);
    const auto count = eigenIndex(columns.size());
    if (count == 0) {
      result.unknowns = alone0_;
      result.variances = variances_;
      result.chi2 = std::max(0.0, chi2OfNone_);
      result.freedom = std::max(1.0, misfit_.freedom);
      return result;
    }
    const Eigen::MatrixXd information = informationOf(result.members, count);
    const Eigen::VectorXd score = score_(columns);
    const Eigen::LDLT<Eigen::MatrixXd> factor{posteriorPrecision(result, information)};
    const Eigen::VectorXd sizes = factor.solve(score);
    const Eigen::MatrixXd spread = factor.solve(Eigen::MatrixXd::Identity(count, count));
    const Eigen::MatrixXd answers = answers_(Eigen::all, columns);
    result.unknowns = alone0_ - answers * sizes;
    result.variances = variances_ + (answers * spread).cwiseProduct(answers).rowwise().sum();
    result.sizes = problem_.plausible(columns).cwiseProduct(sizes);
    result.chi2 = std::max(0.0, chi2OfNone_ - 2 * score.dot(sizes) + sizes.dot(information * sizes));
    result.freedom = std::max(1.0, misfit_.freedom - information.cwiseProduct(spread).sum());
    return result;
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
  void moveToZero(const Eigen::VectorXd& sizes) {
    scoreAtFit_ = score_;
    for (std::size_t group = 0; group < problem_.named; ++group) {
      const ColumnGroup& columns = problem_.groups[group];
      const Eigen::VectorXd own = sizes.segment(columns.first, columns.count);
      if (own.isZero(0)) {
        continue;
      }
      const Eigen::VectorXd scaled = own.cwiseQuotient(problem_.plausible.segment(columns.first, columns.count));
      const Eigen::VectorXd pull = informationWith({group, columns.count}) * scaled;
      fromFitToZero_ += 2 * score_.segment(columns.first, columns.count).dot(scaled) +
                        scaled.dot(pull.segment(columns.first, columns.count));
      score_ += pull;
      alone0_ += answers_.middleCols(columns.first, columns.count) * scaled;
      fitted_.push_back({group, columns.count});
    }
    chi2OfNone_ = misfit_.chi2 + fromFitToZero_;
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
  std::size_t expected_;
  NullModel alone_;
  ScoreTest tests_;
  PoseMisfit misfit_;
  Eigen::VectorXd score_, scoreAtFit_, alone0_, variances_;
  Eigen::MatrixXd answers_; // response of the own unknowns to a unit of each column, sign reversed
  Members fitted_;
  double fromFitToZero_ = 0, chi2OfNone_ = 0, named_ = 1, curves_ = 1;
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
    if (hasGroup(members, group)) {
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

/// The model and all its neighbours (removals, swaps and additions), each with every choice of widths.
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
  std::vector<WindowModel> byWidth;
  const double most = best.cost - 2 * std::log(leastWeight);
  for (const WindowModel& model : result) {
    if (model.cost <= most) { // of the best always, even where its cost swallows the difference
      std::vector<WindowModel> models = window.modelsByWidth(model.members);
      std::move(models.begin(), models.end(), std::back_inserter(byWidth));
    }
  }
  return byWidth;
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

ExplanationCosts costExplanations(const WideModel& wide, const Noise& noise) {
  Window window{wide, noise, 0};
  return {window.costAsFitted(), window.fromFitToZero() + findLikeliest(window).cost};
}

ModelWindow searchModelWindow(const WideModel& wide, const Noise& noise, std::size_t expected) {
  Window window{wide, noise, expected};
  const WindowModel likeliest = findLikeliest(window);
  requireFinite(window.isFinite() && std::isfinite(likeliest.cost));
  Members named = likeliest.members;
  std::erase_if(named, [&](const WindowMember& member) { return member.group >= wide.problem().named; });
  ModelWindow result{.unnamedGain = window.model(named).cost - likeliest.cost};
  result.models = findNeighbours(window, likeliest);
  std::sort(result.models.begin(), result.models.end(),
            [](const WindowModel& a, const WindowModel& b) { return a.cost < b.cost; });
  const WindowModel& best = result.models.front();
  result.misfit = window.misfitOf(best);
  result.freedom = best.freedom;
  for (WindowModel& model : result.models) {
    model.weight = std::exp((best.cost - model.cost) / (2 * result.misfit));
  }
  std::erase_if(result.models, [](const WindowModel& model) { return model.weight < leastWeight; });
  const double kept = std::accumulate(result.models.begin(), result.models.end(), 0.0,
                                      [](double all, const WindowModel& model) { return all + model.weight; });
  result.mean = result.variance = Eigen::VectorXd::Zero(wide.problem().ownCount());
  result.groupWeights.assign(wide.problem().groups.size(), 0);
  for (WindowModel& model : result.models) {
    model.weight /= kept;
    result.mean += model.weight * model.unknowns;
    for (const WindowMember& member : model.members) {
      result.groupWeights[member.group] += model.weight;
    }
  }
  for (const WindowModel& model : result.models) {
    result.variance += model.weight * (result.misfit * model.variances + (model.unknowns - result.mean).cwiseAbs2());
  }
  requireFinite(result.mean.allFinite() && result.variance.allFinite());
  return result;
}

std::array<double, 2> ModelWindow::interval(Eigen::Index unknown) const {
  const double half = misfit > 1 ? studentHalfWidth(freedom) : studentHalfWidth(1e6);
  const auto spread = [&](const WindowModel& model) { return std::sqrt(misfit * model.variances[unknown]); };
  const auto bound = [&](double sign) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const WindowModel& model : models) {
      const double own = model.unknowns[unknown] + sign * half * spread(model);
      least = std::min(least, own);
      most = std::max(most, own);
    }
    const auto excess = [&](double value) {
      double below = 0;
      for (const WindowModel& model : models) {
        const double t = (value - model.unknowns[unknown]) / spread(model);
        below += model.weight * (misfit > 1 ? studentBelow(t, freedom) : 0.5 * std::erfc(-t / std::numbers::sqrt2));
      }
      return below - (sign < 0 ? 0.025 : 0.975);
    };
    if (excess(least) >= 0 || excess(most) <= 0) { // a single model, or identical bounds
      return excess(least) >= 0 ? least : most;
    }
    std::uintmax_t steps = 50;
    const auto [low, high] =
        boost::math::tools::toms748_solve(excess, least, most, boost::math::tools::eps_tolerance<double>(20), steps);
    return 0.5 * (low + high);
  };
  return {bound(-1), bound(1)};
}

} // namespace naocal
