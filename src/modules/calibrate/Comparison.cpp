#include "calibrate/Comparison.hpp"

#include "calibrate/Prediction.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

/// As they are seen: nothing of them is put down to the joints.
std::vector<SightingResidual> plainResiduals(const Measurements& measurements, const Prediction& prediction) {
  Residuals residuals{measurements, prediction.model, Noise{.pixel = 0.3, .encoder = 0, .pose = 0}};
  return residuals.sightings(predicted(residuals, prediction).state);
}

Distances distances(std::vector<double> all) {
  Distances result{0, 0, all.size()};
  if (all.empty()) {
    return result;
  }
  for (double distance : all) {
    result.rmsPx += distance * distance;
  }
  result.rmsPx = std::sqrt(result.rmsPx / static_cast<double>(all.size()));
  std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
  result.medianPx = all[all.size() / 2];
  return result;
}

std::map<std::string, Distances> distances(const std::map<std::string, std::vector<double>>& groups) {
  std::map<std::string, Distances> result;
  for (const auto& [name, all] : groups) {
    result[name] = distances(all);
  }
  return result;
}

} // namespace

Comparison compare(const StoredResult& result, const std::vector<CaptureSet>& sets, const Robot& robot,
                   bool samePlace) {
  const Measurements measurements = measurementsOf(sets, robot, samePlace);
  if (measurements.cornerCount == 0) {
    throw InputError{"these captures show no corner to compare with"};
  }
  const Prediction prediction = predictionOf(result, measurements, samePlace);
  Comparison comparison;
  comparison.ignored = prediction.ignored;
  std::vector<double> all, nominal;
  std::map<std::string, std::vector<double>> byBoard, byCamera, byPose;
  for (const SightingResidual& seen : plainResiduals(measurements, prediction)) {
    const Picture& picture = measurements.pictures[seen.picture];
    for (Eigen::Index i = 0; i < seen.residual.cols(); ++i) {
      const double distance = seen.residual.col(i).norm();
      all.push_back(distance);
      byBoard[measurements.targets[picture.sightings[seen.sighting].view.board()].name].push_back(distance);
      byCamera[measurements.robot.cameras[picture.camera].name].push_back(distance);
      byPose[sets[picture.set].captures[picture.capture].pose].push_back(distance);
    }
  }
  const Prediction drawn = predictionOf(prediction.model, StoredResult{}, measurements, samePlace);
  for (const SightingResidual& seen : plainResiduals(measurements, drawn)) {
    for (Eigen::Index i = 0; i < seen.residual.cols(); ++i) {
      nominal.push_back(seen.residual.col(i).norm());
    }
  }
  comparison.all = distances(all);
  comparison.nominal = distances(nominal);
  comparison.byBoard = distances(byBoard);
  comparison.byCamera = distances(byCamera);
  comparison.byPose = distances(byPose);
  return comparison;
}

double weightedError(const StoredResult& result, const std::vector<CaptureSet>& sets, const Robot& robot,
                     bool samePlace, const Noise& noise) {
  const Measurements measurements = measurementsOf(sets, robot, samePlace);
  const Prediction from = predictionOf(result, measurements, samePlace);
  Residuals quadratic{measurements, from.model, noise}, robust{measurements, from.model, noise, Loss{.scale = 1}};
  // where the joints rest is found first: before that, all corners of a pose look false
  const FitMinimum minimum = predicted(robust, from, predicted(quadratic, from).state);
  double chi2 = 0; // without what the result's own numbers cost
  for (const Eliminated& pose : minimum.linear.eliminated) {
    chi2 += 2 * pose.cost;
  }
  return noise.pixel * std::sqrt(chi2 / static_cast<double>(measurements.cornerCount));
}

nlohmann::json comparisonJson(const Comparison& comparison) {
  const auto one = [](const Distances& distances) {
    return nlohmann::json{{"rmsPx", distances.rmsPx}, {"medianPx", distances.medianPx}, {"corners", distances.corners}};
  };
  const auto many = [&](const std::map<std::string, Distances>& groups) {
    nlohmann::json result = nlohmann::json::object();
    for (const auto& [name, distances] : groups) {
      result[name] = one(distances);
    }
    return result;
  };
  nlohmann::json result = one(comparison.all);
  result["format"] = "naocal-compare";
  result["version"] = 1;
  result["nominal"] = one(comparison.nominal);
  result["byBoard"] = many(comparison.byBoard);
  result["byCamera"] = many(comparison.byCamera);
  result["byPose"] = many(comparison.byPose);
  result["ignored"] = comparison.ignored;
  return result;
}

} // namespace naocal
