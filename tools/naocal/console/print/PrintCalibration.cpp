#include "console/print/PrintCalibration.hpp"

#include "calibration/result/Wording.hpp"
#include "console/print/PrintFindings.hpp"
#include "console/print/PrintText.hpp"
#include "effects/Catalogue.hpp"
#include "io/Units.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <utility>
#include <vector>

namespace naocal {

namespace {

std::string bar(double share) {
  std::string result;
  for (int i = 0; i < static_cast<int>(std::lround(10 * std::clamp(share, 0.0, 1.0))); ++i) {
    result += "█";
  }
  return result;
}

/// What the uncertainty means for the task.
void printTask(const CalibrationResult& result) {
  if (result.task) {
    printText("{}: {} off (1 sigma), at most {} (99.95 %); tolerance {}\n", result.task->what,
              formatSize(result.task->sigma, "m"), formatSize(result.task->bound, "m"),
              formatSize(result.task->tolerance, "m"));
  }
}

void printEstimates(const Model& model, const CalibrationResult& result) {
  printText("\n  {:<38} {:>12}     {:>10}     learned\n", "unknown", "estimate", "±  1 sigma");
  for (const Term& term : model.terms()) {
    for (std::size_t i = 0; i < term.effect.unknowns.size() && !term.isPlacement && term.requested; ++i) {
      const Unknown& unknown = term.effect.unknowns[i];
      const Estimate& estimate = result.estimates[term.first + i];
      const auto [unit, scale] = displayUnit(unknown.unit);
      const std::string name = nameUnknown(term, i);
      printText("  {:<38} {:>10.4f} {:<4}  {:>8.4f} {:<4}  {:>3.0f} % {}\n", name, scale * estimate.best(), unit,
                scale * estimate.bestSigma(), unit, 100 * estimate.learned, bar(estimate.learned));
    }
  }
}

/// Errors and noise of measurements other than corners.
void printReadings(const FittedModel& fitted) {
  const Measurements& measurements = fitted.measurements;
  if (fitted.fit.readings.empty()) {
    return;
  }
  printText("error of {} readings: {} rms\n", measurements.witnessCount, formatSizes(fitted.fit.readings));
  for (std::size_t i = 0; i < measurements.levels.size(); ++i) {
    const ReadingLevel& level = measurements.levels[i];
    const double sigma = sigmaOf(measurements, fitted.fit.noise, i);
    const bool isLength = level.unit == ReadingLevel::Unit::metres;
    printText("noise of {} per axis, 1 sigma: {:.3g} {} ({})\n", level.name, isLength ? 1e3 * sigma : degrees(sigma),
              isLength ? "mm" : "°", level.isGiven ? "given" : "estimated");
  }
}

/// Pictures with corners; others were left out, or show no board.
std::ptrdiff_t countPictures(const Measurements& measurements) {
  return std::count_if(measurements.pictures.begin(), measurements.pictures.end(),
                       [](const ImageObservation& picture) { return !picture.observations.empty(); });
}

void printCorners(const FittedModel& fitted) {
  printText("prediction error {:.2f} px rms (median {:.2f} px); ", fitted.fit.rmsPx, fitted.fit.medianPx);
}

} // namespace

void printCalibration(const FittedModel& fitted) {
  printFindings(fitted.fit.findings);
  printText("{}", "\n");
  const bool hasCorners = fitted.measurements.cornerCount > 0;
  const std::string what = hasCorners ? fmt::format("{} corners in {} pictures", fitted.measurements.cornerCount,
                                                    countPictures(fitted.measurements))
                                      : fmt::format("{} readings", fitted.measurements.witnessCount);
  printText("{}: {} of {} poses, {} unknowns; {} after {} iterations in {:.1f} ms\n", fitted.measurements.robot.model,
            what, fitted.measurements.poses.size(), fitted.model.unknownCount(),
            fitted.fit.converged ? "converged" : "NOT converged", fitted.fit.iterations, 1e3 * fitted.fit.seconds);
  if (hasCorners) {
    printCorners(fitted);
  }
  printText("chi2/dof {:.3f}, p {:.2g}\n", fitted.fit.chi2 / std::max(1.0, fitted.fit.dof), fitted.fit.pValue);
  printReadings(fitted);
  printText("noise, 1 sigma ({}): {}{}\n", fitted.fit.noiseSource,
            hasCorners
                ? fmt::format("corners {:.3f} px anew in each picture and {:.3f} px alike in all pictures of a rest, ",
                              fitted.fit.noise.pixel, fitted.fit.noise.pixelAlike)
                : "",
            formatJointNoise(fitted.fit.noise, fitted.measurements.hasUnknownSteps()));
  printTask(fitted.fit);
  printEstimates(fitted.model, fitted.fit);
  for (const Outlier& outlier : fitted.fit.outliers) {
    const ImageObservation& picture = fitted.measurements.pictures[outlier.picture];
    printText("\ndoubtful: capture {} ({}), board {}: {} {:.1f} px off{}", fitted.measurements.captureOf(picture).id,
              fitted.measurements.captureOf(picture).camera,
              fitted.measurements.targets[picture.observations[outlier.observation].view.board()].name,
              outlier.whole
                  ? fmt::format("{} corners together", outlier.corners.size())
                  : fmt::format("{} corner{}", outlier.corners.size(), outlier.corners.size() == 1 ? "" : "s"),
              outlier.distance, outlier.whole && !outlier.move ? ": was the board moved or the robot touched?" : "");
  }
  for (const DoubtfulReading& reading : fitted.fit.doubtfulReadings) {
    const ImageObservation& picture = fitted.measurements.pictures[reading.picture];
    printText("\ndoubtful: capture {}, {}: does not fit the rest", fitted.measurements.captureOf(picture).id,
              picture.witnesses[reading.witness].witness->target());
  }
  if (fitted.fit.restartsTried > 0) {
    printText("\n{} random restarts {} the answer", fitted.fit.restartsTried,
              fitted.fit.restartsChanged ? "CHANGED" : "did not change");
  }
  printText("{}", "\n");
}

} // namespace naocal
