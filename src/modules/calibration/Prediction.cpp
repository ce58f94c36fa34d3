#include "calibration/Prediction.hpp"

#include "calibration/Fit.hpp"
#include "calibration/Initialization.hpp"
#include "effects/Catalogue.hpp"
#include "estimation/ModelBuilder.hpp"
#include "estimation/ModelFile.hpp"
#include "io/FileVersion.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

/// Minimum cost over the free unknowns, from `start`. Throws InputError if the captures cannot be predicted at all.
FitMinimum predict(Residuals& residuals, const Prediction& prediction, const Residuals::State& start) {
  residuals.setFree(prediction.free);
  auto minimum = levenbergMarquardt(residuals, start);
  if (!minimum) {
    throw InputError{
        "these captures cannot be predicted: a corner that was seen would lie behind the camera; is it the "
        "robot that the result was made for?"};
  }
  return *std::move(minimum);
}

/// As above, from the prediction's unknowns.
FitMinimum predict(Residuals& residuals, const Prediction& prediction) {
  return predict(residuals, prediction, residuals.startState(prediction.unknowns));
}

/// Residuals with joint angles as read: no deflections are fitted.
struct PlainResiduals {
  std::vector<BoardResidual> boards;
  ReadingLengths readings;
};

PlainResiduals plainResiduals(const Measurements& measurements, const Prediction& prediction) {
  Residuals residuals{measurements, prediction.model, Noise{.pixel = 0.3, .encoder = 0, .pose = 0}};
  const Residuals::State state = predict(residuals, prediction).state;
  return {residuals.boardResiduals(state), collectLengths(measurements, residuals.witnessResiduals(state))};
}

std::map<std::string, ResidualSummary> summarizeGroups(const std::map<std::string, std::vector<double>>& groups) {
  std::map<std::string, ResidualSummary> result;
  for (const auto& [name, all] : groups) {
    result[name] = summarizeDistances(all);
  }
  return result;
}

/// The model of a result on other captures: its terms as far as they apply, and the placements.
Model modelFromResult(const StoredResult& result, const Measurements& measurements, std::vector<std::string>& ignored) {
  const std::vector<Effect> effects =
      parseEffects(nlohmann::json::parse(result.definitions), "model.define", measurements.robot);
  const Model base = buildModel(measurements);
  std::vector<std::string> with, without;
  for (const Term& term : base.terms()) {
    if (!term.isPlacement && std::find(result.terms.begin(), result.terms.end(), term.label()) == result.terms.end()) {
      without.push_back(term.label());
    }
  }
  for (const std::string& term : result.terms) {
    try {
      buildModel(measurements, {term}, {}, effects);
      with.push_back(term);
    } catch (const InputError&) {
      ignored.push_back(term);
    }
  }
  Model model = buildModel(measurements, with, without, effects);
  std::erase_if(ignored, [&](const std::string& label) { // offsets added along with load-dependent effects
    return std::any_of(model.terms().begin(), model.terms().end(),
                       [&](const Term& term) { return term.label() == label; });
  });
  return model;
}

/// Whether a placement in a result holds for further captures, too: floor boards are laid out and robots put down anew.
bool isLasting(const Term& term, const Measurements& measurements) {
  const PlaceKind place = term.effect.placeKind;
  return place != PlaceKind::stance && (place != PlaceKind::board || !measurements.targets[term.placeIndex].isFlat);
}

/// Whether a placement that a result does not tell is estimated: not where it is one on a NAO, of which the guess
/// holds.
bool isEstimated(const Term& term, const Measurements& measurements) {
  return term.effect.placeKind != PlaceKind::board || measurements.targets[term.placeIndex].inWorld ||
         measurements.quantities.scene().hasLinkSteps;
}

/// Takes the unknowns of a model for the new captures from the result.
Prediction preparePrediction(const Model& model, const StoredResult& result, const Measurements& measurements,
                             bool samePlace) {
  const auto count = static_cast<Eigen::Index>(model.unknownCount());
  Prediction all{model, Eigen::VectorXd::Zero(count), std::vector<bool>(model.unknownCount(), false), {}};
  const std::vector<std::string> names = model.names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto value = result.values.find(names[i]);
    all.unknowns[static_cast<Eigen::Index>(i)] = value == result.values.end() ? 0 : value->second;
  }
  all.unknowns = initializePlacements(measurements, model, all.unknowns);
  for (const Term& term : model.terms()) {
    if (!term.isPlacement) {
      continue;
    }
    const bool isTaken = (samePlace || isLasting(term, measurements)) &&
                         placeAsStored(result.placements, measurements, term, all.unknowns);
    if (!isTaken) {
      std::fill_n(all.free.begin() + static_cast<std::ptrdiff_t>(term.first), term.effect.unknowns.size(),
                  isEstimated(term, measurements));
    }
  }
  return all;
}

/// The same with the robot's drawing alone. Where no placement can be estimated from that, the search starts at those
/// of the result.
PlainResiduals plainResidualsAsDrawn(const Measurements& measurements, const Prediction& prediction, bool samePlace) {
  Prediction drawn = preparePrediction(prediction.model, StoredResult{}, measurements, samePlace);
  try {
    return plainResiduals(measurements, drawn);
  } catch (const InputError&) {
    for (std::size_t i = 0; i < drawn.free.size(); ++i) {
      if (drawn.free[i]) {
        drawn.unknowns[static_cast<Eigen::Index>(i)] = prediction.unknowns[static_cast<Eigen::Index>(i)];
      }
    }
    return plainResiduals(measurements, drawn);
  }
}

} // namespace

StoredResult readKnownResult(const std::filesystem::path& file) {
  StoredResult result = readResult(file);
  std::vector<std::string> known{effectName::boardPlacement, effectName::stancePlacement};
  for (const Effect& effect : allEffects()) {
    known.push_back(effect.name);
    known.push_back(effect.alias);
  }
  for (const nlohmann::json& definition : nlohmann::json::parse(result.definitions)) {
    if (definition.is_object() && definition.contains("name") && definition["name"].is_string()) {
      known.push_back(definition["name"]);
    }
  }
  for (const std::string& term : result.terms) {
    const std::string name = term.substr(0, term.find('@'));
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw InputError{fmt::format("{}: effects: expected effects of 'naocal effects' or of the result's own "
                                   "definitions, found \"{}\"; near it are {}",
                                   file.string(), term, fmt::join(closestNames(name, known), ", "))};
    }
  }
  return result;
}

Comparison compare(const StoredResult& result, const std::vector<CaptureSet>& sets, const Robot& robot,
                   bool samePlace) {
  const Measurements measurements = buildMeasurements(sets, robot, samePlace);
  if (measurements.cornerCount + measurements.witnessCount == 0) {
    throw InputError{"these captures show no corner to compare with"};
  }
  const Prediction prediction = preparePrediction(result, measurements, samePlace);
  Comparison comparison;
  comparison.ignored = prediction.ignored;
  std::vector<double> all, nominal;
  std::map<std::string, std::vector<double>> byBoard, byCamera, byPose;
  const PlainResiduals errors = plainResiduals(measurements, prediction);
  comparison.readings = summarizeReadings(errors.readings);
  for (const BoardResidual& seen : errors.boards) {
    const ImageObservation& picture = measurements.pictures[seen.picture];
    for (Eigen::Index i = 0; i < seen.residual.cols(); ++i) {
      const double distance = seen.residual.col(i).norm();
      all.push_back(distance);
      byBoard[measurements.targets[picture.observations[seen.observation].view.board()].name].push_back(distance);
      byCamera[measurements.robot.cameras[picture.camera].name].push_back(distance);
      byPose[measurements.captureOf(picture).pose].push_back(distance);
    }
  }
  const PlainResiduals drawnErrors = plainResidualsAsDrawn(measurements, prediction, samePlace);
  comparison.nominalReadings = summarizeReadings(drawnErrors.readings);
  for (const BoardResidual& seen : drawnErrors.boards) {
    for (Eigen::Index i = 0; i < seen.residual.cols(); ++i) {
      nominal.push_back(seen.residual.col(i).norm());
    }
  }
  comparison.all = summarizeDistances(all);
  comparison.nominal = summarizeDistances(nominal);
  comparison.byBoard = summarizeGroups(byBoard);
  comparison.byCamera = summarizeGroups(byCamera);
  comparison.byPose = summarizeGroups(byPose);
  return comparison;
}

PredictionErrors predictionErrors(const StoredResult& result, const std::vector<CaptureSet>& sets, const Robot& robot,
                                  bool samePlace) {
  const Measurements measurements = buildMeasurements(sets, robot, samePlace);
  const PlainResiduals errors = plainResiduals(measurements, preparePrediction(result, measurements, samePlace));
  return {collectDistances(errors.boards), errors.readings};
}

double weightedError(const StoredResult& result, const std::vector<CaptureSet>& sets, const Robot& robot,
                     bool samePlace, const Noise& noise) {
  const Measurements measurements = buildMeasurements(sets, robot, samePlace);
  const Prediction from = preparePrediction(result, measurements, samePlace);
  Residuals quadratic{measurements, from.model, noise}, robust{measurements, from.model, noise, Loss{.scale = 1}};
  // first fits the deflections: without them all corners of a pose look like outliers
  const FitMinimum minimum = predict(robust, from, predict(quadratic, from).state);
  double chi2 = 0; // without the prior cost of the result's unknowns
  for (const MarginalSystem& pose : minimum.linear.eliminated) {
    chi2 += 2 * pose.cost;
  }
  return noise.pixel * std::sqrt(chi2 / static_cast<double>(measurements.cornerCount + measurements.witnessCount));
}

nlohmann::json comparisonJson(const Comparison& comparison) {
  const auto one = [](const ResidualSummary& distances) {
    return nlohmann::json{{"rmsPx", distances.rmsPx}, {"medianPx", distances.medianPx}, {"corners", distances.corners}};
  };
  const auto many = [&](const std::map<std::string, ResidualSummary>& groups) {
    nlohmann::json result = nlohmann::json::object();
    for (const auto& [name, distances] : groups) {
      result[name] = one(distances);
    }
    return result;
  };
  nlohmann::json result = withFormat("naocal-compare", one(comparison.all));
  result.update(toJson(comparison.readings));
  result["nominal"] = one(comparison.nominal);
  result["nominal"].update(toJson(comparison.nominalReadings));
  result["byBoard"] = many(comparison.byBoard);
  result["byCamera"] = many(comparison.byCamera);
  result["byPose"] = many(comparison.byPose);
  result["ignored"] = comparison.ignored;
  return result;
}

Prediction preparePrediction(const StoredResult& result, const Measurements& measurements, bool samePlace) {
  std::vector<std::string> ignored;
  Prediction prediction =
      preparePrediction(modelFromResult(result, measurements, ignored), result, measurements, samePlace);
  prediction.ignored = std::move(ignored);
  return prediction;
}

} // namespace naocal
