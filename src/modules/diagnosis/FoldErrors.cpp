#include "diagnosis/FoldErrors.hpp"

#include "calibration/Calibration.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using nlohmann::json;
using PoseName = std::pair<std::size_t, std::string>; // set and pose

/// Fold of each pose: dealt in turn in the order in which they were taken.
std::map<PoseName, std::size_t> dealPoses(const std::vector<CaptureSet>& sets, std::size_t folds) {
  std::map<PoseName, std::size_t> foldOf;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    std::vector<const Capture*> inOrder;
    for (const Capture& capture : sets[set].captures) {
      inOrder.push_back(&capture);
    }
    std::stable_sort(inOrder.begin(), inOrder.end(),
                     [](const Capture* a, const Capture* b) { return a->time < b->time; });
    for (const Capture* capture : inOrder) {
      foldOf.try_emplace({set, capture->pose}, foldOf.size() % folds);
    }
  }
  if (foldOf.size() < folds) {
    throw InputError{
        fmt::format("--folds: expected at most as many folds as poses, found {} for {} poses", folds, foldOf.size())};
  }
  return foldOf;
}

/// The captures of a fold, or all others.
std::vector<CaptureSet> keepFold(std::vector<CaptureSet> sets, const std::map<PoseName, std::size_t>& foldOf,
                                 std::size_t fold, bool isInside) {
  for (std::size_t set = 0; set < sets.size(); ++set) {
    std::erase_if(sets[set].captures, [&](const Capture& capture) {
      return (foldOf.at({set, capture.pose}) == fold) != isInside;
    });
  }
  std::erase_if(sets, [](const CaptureSet& set) { return set.captures.empty(); });
  return sets;
}

/// A fit as what `compare` predicts with.
StoredResult fitToPredict(const std::vector<CaptureSet>& sets, const Robot& robot, bool samePlace,
                          const std::vector<std::string>& terms, const SuggestedModel& asked) {
  const Measurements measurements = buildMeasurements(sets, robot, samePlace);
  const Model model = buildModel(measurements, terms, asked.without, asked.effects);
  CalibrationOptions options;
  options.testMissingEffects = false;
  const CalibrationResult result = calibrate(measurements, model, options);
  return parseResult(resultJson({measurements, model, result}, {}), "fold");
}

json summaryJson(const ReadingSummary& summary) {
  return {{"rms", summary.rms}, {"mean", summary.mean}, {"median", summary.median}, {"points", summary.points}};
}

json errorsJson(const PredictionErrors& errors) {
  json result = json::object();
  if (!errors.pixels.empty()) {
    result["pixels"] = summaryJson(summarizeLengths(errors.pixels));
  }
  const ReadingErrors readings = summarizeReadings(errors.readings);
  for (const auto& [tracker, summary] : readings.metres) {
    result["metres"][tracker] = summaryJson(summary);
  }
  for (const auto& [tracker, summary] : readings.radians) {
    result["radians"][tracker] = summaryJson(summary);
  }
  if (readings.contacts) {
    result["contacts"] = summaryJson(*readings.contacts);
  }
  return result;
}

} // namespace

FoldErrors predictFolds(const std::vector<CaptureSet>& sets, const Robot& robot, bool samePlace, std::size_t folds,
                        const SuggestedModel& model) {
  const std::map<PoseName, std::size_t> foldOf = dealPoses(sets, folds);
  std::vector<std::string> all = model.with;
  all.insert(all.end(), model.suggested.begin(), model.suggested.end());
  FoldErrors result{.folds = folds, .given = {}, .suggested = {}};
  for (std::size_t fold = 0; fold < folds; ++fold) {
    const std::vector<CaptureSet> seen = keepFold(sets, foldOf, fold, false),
                                  unseen = keepFold(sets, foldOf, fold, true);
    const auto add = [&](const std::vector<std::string>& terms, PredictionErrors& errors) {
      const PredictionErrors here =
          predictionErrors(fitToPredict(seen, robot, samePlace, terms, model), unseen, robot, samePlace);
      errors.pixels.insert(errors.pixels.end(), here.pixels.begin(), here.pixels.end());
      errors.readings.append(here.readings);
    };
    add(model.with, result.given);
    if (!model.suggested.empty()) {
      add(all, result.suggested);
    }
  }
  if (model.suggested.empty()) {
    result.suggested = result.given;
  }
  return result;
}

json toJson(const FoldErrors& errors) {
  return {{"folds", errors.folds}, {"given", errorsJson(errors.given)}, {"suggested", errorsJson(errors.suggested)}};
}

} // namespace naocal
