#include "calibrate/Prediction.hpp"

#include "calibrate/StartingPlacements.hpp"
#include "io/InputError.hpp"
#include "residuals/ModelFile.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

/// The model of a result on other captures: its terms as far as they are touched there, and the placements.
Model modelOf(const StoredResult& result, const Measurements& measurements, std::vector<std::string>& ignored) {
  const std::vector<Effect> effects =
      effectsWith(nlohmann::json::parse(result.definitions), "model.define", measurements.robot);
  const Model base = makeModel(measurements);
  std::vector<std::string> with, without;
  for (const Term& term : base.terms()) {
    if (!term.isPlacement && std::find(result.terms.begin(), result.terms.end(), term.label()) == result.terms.end()) {
      without.push_back(term.label());
    }
  }
  for (const std::string& term : result.terms) {
    try {
      makeModel(measurements, {term}, {}, effects);
      with.push_back(term);
    } catch (const InputError&) {
      ignored.push_back(term);
    }
  }
  Model model = makeModel(measurements, with, without, effects);
  std::erase_if(ignored, [&](const std::string& label) { // offsets that come along with effects of weight
    return std::any_of(model.terms().begin(), model.terms().end(),
                       [&](const Term& term) { return term.label() == label; });
  });
  return model;
}

/// A placement's unknowns, so that start + unknowns = `placement`.
void placeAt(const Term& term, const Eigen::Matrix<double, 6, 1>& start, const Placement& placement,
             Eigen::VectorXd& unknowns) {
  const std::map<std::string, std::pair<int, double>> numbers{
      {"x", {0, placement.x}},       {"y", {1, placement.y}},         {"z", {2, placement.z}},
      {"roll", {3, placement.roll}}, {"pitch", {4, placement.pitch}}, {"yaw", {5, placement.yaw}}};
  for (std::size_t i = 0; i < term.effect.unknowns.size(); ++i) {
    const auto& [number, value] = numbers.at(term.effect.unknowns[i].name);
    unknowns[static_cast<Eigen::Index>(term.first + i)] = value - start[number];
  }
}

} // namespace

Prediction predictionOf(const Model& model, const StoredResult& result, const Measurements& measurements,
                        bool samePlace) {
  const auto count = static_cast<Eigen::Index>(model.unknownCount());
  Prediction all{model, Eigen::VectorXd::Zero(count), std::vector<bool>(model.unknownCount(), false), {}};
  const std::vector<std::string> names = model.names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto value = result.values.find(names[i]);
    all.unknowns[static_cast<Eigen::Index>(i)] = value == result.values.end() ? 0 : value->second;
  }
  all.unknowns = startingUnknowns(measurements, model, all.unknowns);
  for (const Term& term : model.terms()) {
    if (!term.isPlacement) {
      continue;
    }
    const bool isBoard = term.effect.place == Place::board;
    const bool onFloor = !isBoard || measurements.targets[term.at].onFloor;
    const auto& known = isBoard ? result.boards : result.stances;
    const auto placement = known.find(term.place);
    if (placement != known.end() && (samePlace || !onFloor)) {
      const Belief& drawn = measurements.pictures.front().drawn;
      const Eigen::Matrix<double, 6, 1> start =
          isBoard ? Eigen::Matrix<double, 6, 1>{drawn.boardPlacement(term.at)} : Eigen::Matrix<double, 6, 1>::Zero();
      placeAt(term, start, placement->second, all.unknowns);
    } else {
      std::fill_n(all.free.begin() + static_cast<std::ptrdiff_t>(term.first), term.effect.unknowns.size(), onFloor);
    }
  }
  return all;
}

Prediction predictionOf(const StoredResult& result, const Measurements& measurements, bool samePlace) {
  std::vector<std::string> ignored;
  Prediction prediction = predictionOf(modelOf(result, measurements, ignored), result, measurements, samePlace);
  prediction.ignored = std::move(ignored);
  return prediction;
}

FitMinimum predicted(Residuals& residuals, const Prediction& prediction, const Residuals::State& start) {
  residuals.freeOnly(prediction.free);
  auto minimum = levenbergMarquardt(residuals, start);
  if (!minimum) {
    throw InputError{
        "these captures cannot be predicted: a corner that was seen would lie behind the camera; is it the "
        "robot that the result was made for?"};
  }
  return *std::move(minimum);
}

FitMinimum predicted(Residuals& residuals, const Prediction& prediction) {
  return predicted(residuals, prediction, residuals.start(prediction.unknowns));
}

} // namespace naocal
