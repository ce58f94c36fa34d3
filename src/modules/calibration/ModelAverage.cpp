#include "calibration/ModelAverage.hpp"

#include "inference/Thresholds.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>

namespace naocal {

namespace {

constexpr double boundProbability = 0.9995;
constexpr double leastShoulder = 1e-4; // weight; a rarer explanation can hardly reach the 0.025 % beyond a bound
constexpr double farShoulder = 1.5;    // ratio of bounds with and without an explanation, from which on it is named

/// Unknowns that both models have: (index in `model`, index in `other`).
std::vector<std::pair<Eigen::Index, Eigen::Index>> sharedUnknowns(const Model& model, const Model& other) {
  std::vector<std::pair<Eigen::Index, Eigen::Index>> result;
  for (const Term& own : model.terms()) {
    for (const Term& term : other.terms()) {
      for (std::size_t i = 0; own.label() == term.label() && i < own.effect.unknowns.size(); ++i) {
        result.emplace_back(eigenIndex(own.first + i), eigenIndex(term.first + i));
      }
    }
  }
  return result;
}

/// An explanation by groups of the window's problem.
Explanation describeGroups(const MissingEffectAnalysis& explained, const std::vector<std::size_t>& groups,
                           const std::vector<Term>& added) {
  Explanation result;
  for (const std::size_t group : groups) {
    result.effects.push_back(explained.names[group]);
  }
  for (const Term& term : added) {
    if (std::erase(result.effects, term.label()) == 0) {
      result.without.push_back(term.label());
    }
  }
  return result;
}

double widthOf(const std::array<double, 2>& ends) {
  return ends[1] - ends[0];
}

} // namespace

ModelAverage::ModelAverage(const MissingEffectAnalysis& explained, const Model& model)
    : explained_{explained}, window_{explained.window}, shared_{sharedUnknowns(model, explained.own)},
      levels_{explained.fit.minimum.linear, explained.fit.minimum.state.unknowns, model.sigmas(), explained.levels,
              explained.window.misfit} {
  std::map<std::vector<std::size_t>, std::vector<std::size_t>> byGroups;
  for (std::size_t i = 0; i < window_.models.size(); ++i) {
    std::vector<std::size_t> groups;
    for (const WindowMember& member : window_.models[i].members) {
      groups.push_back(member.group);
    }
    byGroups[groups].push_back(i);
  }
  std::vector<std::pair<Explanation, std::vector<std::size_t>>> all;
  for (auto& [groups, models] : byGroups) {
    all.emplace_back(describeGroups(explained, groups, addedEffects(model)), std::move(models));
    for (const std::size_t i : all.back().second) {
      all.back().first.weight += window_.models[i].weight;
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.first.weight > b.first.weight; });
  for (auto& [explanation, models] : all) {
    explanations_.push_back(std::move(explanation));
    models_.push_back(std::move(models));
  }
}

std::vector<Eigen::Index> ModelAverage::unknowns() const {
  std::vector<Eigen::Index> result;
  std::transform(shared_.begin(), shared_.end(), std::back_inserter(result),
                 [](const auto& indices) { return indices.first; });
  return result;
}

std::optional<Undetectable> ModelAverage::worstBias(const Eigen::MatrixXd& own, const Eigen::MatrixXd& columns) const {
  const WindowModel& likeliest = window_.models.front();
  std::optional<Undetectable> result;
  for (const UndetectedEffect& effect : window_.undetected) {
    const ColumnGroup& group = wide().problem().groups[effect.group];
    const Eigen::MatrixXd shift = own * effect.biases + columns(Eigen::all, likeliest.columns) * effect.taken -
                                  columns.middleCols(group.first, group.count) * effect.sizes;
    const double size = std::sqrt(std::max(0.0, symmetricEigenvalues(shift * shift.transpose()).maxCoeff()));
    if (!result || size > result->bias) {
      result = Undetectable{explained_.names[effect.group], "task", size, "m"};
    }
  }
  return result;
}

std::optional<Eigen::Index> ModelAverage::ownIndex(Eigen::Index unknown) const {
  const auto found =
      std::find_if(shared_.begin(), shared_.end(), [&](const auto& indices) { return indices.first == unknown; });
  return found == shared_.end() ? std::nullopt : std::optional{found->second};
}

std::optional<std::pair<std::string, double>> ModelAverage::worstBiasOf(Eigen::Index unknown) const {
  const auto own = ownIndex(unknown);
  if (!own) {
    return std::nullopt;
  }
  const auto columns = Eigen::MatrixXd::Zero(1, wide().problem().plausible.size());
  const auto worst = worstBias(Eigen::RowVectorXd::Unit(window_.mean.size(), *own), columns);
  return worst ? std::optional{std::pair{worst->effect, worst->bias}} : std::nullopt;
}

Averaged ModelAverage::of(Eigen::Index unknown) const {
  return along(Eigen::VectorXd::Unit(levels_.size(), unknown),
               Eigen::VectorXd::Unit(window_.mean.size(), ownIndex(unknown).value()),
               Eigen::VectorXd::Zero(wide().problem().plausible.size()));
}

Averaged ModelAverage::along(const Eigen::VectorXd& direction, const Eigen::VectorXd& own,
                             const Eigen::VectorXd& columns) const {
  const UncertainVariance variance = levels_.along(direction, false);
  const std::vector<StudentMixture::Part> parts = window_.along(own, columns);
  Averaged result;
  for (const StudentMixture::Part& part : parts) {
    result.value += part.weight * part.centre;
  }
  double squares = 0;
  for (const StudentMixture::Part& part : parts) {
    const double away = part.centre - result.value;
    squares += part.weight * (variance.widening * part.scale * part.scale + away * away);
  }
  result.sigma = std::sqrt(squares);
  const StudentMixture mixture = mixtureOf(parts, variance);
  result.interval = mixture.interval(0.95);
  result.bound = mixture.interval(boundProbability);
  result.shoulder = findShoulder(parts, variance);
  return result;
}

StudentMixture ModelAverage::mixtureOf(const std::vector<StudentMixture::Part>& parts,
                                       const UncertainVariance& variance) const {
  double spread = 1 + variance.relativeSpread, freedom = variance.freedom(), factor = variance.widening;
  if (window_.misfit > 1 && window_.freedom > 4) {
    spread *= 1 + 2 / (window_.freedom - 4);
    factor *= window_.freedom / (window_.freedom - 2);
    freedom = UncertainVariance{.relativeSpread = spread - 1}.freedom();
  } else if (window_.misfit > 1) {
    freedom = std::min(freedom, window_.freedom);
  }
  if (freedom > 4) {
    factor *= (freedom - 2) / freedom;
  }
  std::vector<StudentMixture::Part> widened = parts;
  for (StudentMixture::Part& part : widened) {
    part.scale *= std::sqrt(factor);
  }
  return {widened, freedom};
}

std::optional<Shoulder> ModelAverage::findShoulder(const std::vector<StudentMixture::Part>& parts,
                                                   const UncertainVariance& variance) const {
  const auto width = [&](const std::vector<StudentMixture::Part>& some) {
    return widthOf(mixtureOf(some, variance).interval(boundProbability));
  };
  double most = farShoulder * width(partsOf(parts, {0}));
  if (explanations_.size() < 2 || width(parts) <= most) {
    return std::nullopt;
  }
  std::optional<Shoulder> result;
  for (std::size_t i = 1; i < explanations_.size() && explanations_[i].weight >= leastShoulder; ++i) {
    const double together = width(partsOf(parts, {0, i}));
    if (together > most) {
      most = together;
      const std::vector<StudentMixture::Part> own = partsOf(parts, {i});
      const double value = std::accumulate(
          own.begin(), own.end(), 0.0, [](double sum, const auto& part) { return sum + part.weight * part.centre; });
      result = Shoulder{explanations_[i].effects, explanations_[i].without, explanations_[i].weight, value};
    }
  }
  return result;
}

std::vector<StudentMixture::Part> ModelAverage::partsOf(const std::vector<StudentMixture::Part>& parts,
                                                        std::initializer_list<std::size_t> explanations) const {
  std::vector<StudentMixture::Part> result;
  double weight = 0;
  for (const std::size_t explanation : explanations) {
    for (const std::size_t model : models_[explanation]) {
      result.push_back(parts[model]);
      weight += parts[model].weight;
    }
  }
  for (StudentMixture::Part& part : result) {
    part.weight /= weight;
  }
  return result;
}

} // namespace naocal
