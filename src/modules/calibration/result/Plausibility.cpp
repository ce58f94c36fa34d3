#include "calibration/result/Plausibility.hpp"

#include "calibration/ReadingNoise.hpp"
#include "calibration/result/Wording.hpp"
#include "effects/Catalogue.hpp"
#include "inference/Thresholds.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace naocal {

namespace {

/// "32°"; beyond a turn the number says nothing.
std::string formatTurn(double angle) {
  const double turned = std::abs(degrees(angle));
  return turned <= 360 ? fmt::format("{:.0f}°", turned) : "more than a turn";
}

std::optional<std::string> describeFarOffset(const Term& term, double value) {
  const bool slides = term.effect.unknowns.front().unit == "m";
  if (std::abs(value) <= (slides ? threshold::farthestSlide : threshold::farthestTurn)) {
    return std::nullopt;
  }
  return fmt::format("{}'s zero would be off by {}, which no robot's is", describeUnknown(term, 0),
                     slides ? fmt::format("{:.0f} mm", 1e3 * std::abs(value)) : formatTurn(value));
}

std::optional<std::string> describeFarTurn(const Term& term, std::span<const double> values) {
  bool isFar = false;
  double square = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double most = std::max(threshold::farthestTurn, threshold::farthestSigmas * term.effect.unknowns[i].sigma);
    isFar |= std::abs(values[i]) > most;
    square += values[i] * values[i];
  }
  if (!isFar) {
    return std::nullopt;
  }
  return fmt::format("camera {} would be turned by {} in its mount, which no camera is", term.placeName,
                     formatTurn(std::sqrt(square)));
}

/// Whether errors of readings are beyond what any robot is wrong by, and beyond their noise where that is given.
bool areImpossible(const ReadingErrors& errors, const Measurements& measurements, const Noise& noise) {
  for (std::size_t i = 0; i < measurements.levels.size(); ++i) {
    const ReadingLevel& level = measurements.levels[i];
    const bool isLength = level.unit == ReadingLevel::Unit::metres;
    const auto& summaries = isLength ? errors.metres : errors.radians;
    const auto found = summaries.find(level.name);
    const double rms = level.name == contactLevel && errors.contacts ? errors.contacts->rms
                       : found == summaries.end()                    ? 0
                                                                     : found->second.rms;
    const double ofNoise = std::sqrt(3.0) * sigmaOf(measurements, noise, i);
    if (rms > (isLength ? threshold::impossibleMetres : threshold::impossibleRadians) &&
        (!level.isGiven || rms > threshold::impossibleNoises * ofNoise)) {
      return true;
    }
  }
  return false;
}

/// rms distance of corners that no robot has [px]: the same angle through the longest lens.
double impossibleDistance(const Measurements& measurements) {
  double most = threshold::impossiblePx;
  for (const CaptureSet& set : *measurements.sets) {
    for (const auto& [name, camera] : set.cameras) {
      most = std::max(most, threshold::impossibleRadians * camera.fx);
    }
  }
  return most;
}

void addGrossNoise(const FittedModel& fitted, std::vector<Finding>& findings) {
  for (std::size_t i = 0; i < fitted.measurements.levels.size(); ++i) {
    const ReadingLevel& level = fitted.measurements.levels[i];
    const bool isLength = level.unit == ReadingLevel::Unit::metres;
    const double sigma = sigmaOf(fitted.measurements, fitted.fit.noise, i);
    constexpr double nearly = 0.95; // the search for a level ends within a few percent of its upper end
    if (!level.isGiven && sigma > nearly * mostNoiseOf(level)) {
      findings.push_back(makeFinding(
          "noise", level.name, FindingLevel::stop,
          fmt::format("the readings of {} scatter by {} (1 sigma) or more, which no instrument does: something is "
                      "wrong with them or with the model; if the instrument is that coarse, give its sigma in the file",
                      level.name,
                      isLength ? fmt::format("{:.1f} mm", 1e3 * sigma) : fmt::format("{:.1f}°", degrees(sigma))),
          fitted.measurements));
      findings.back().numbers = {{"sigma", sigma}};
    }
  }
}

void addImplausibleValues(const FittedModel& fitted, std::vector<Finding>& findings) {
  for (const Term& term : fitted.model.terms()) {
    std::vector<double> averaged;
    for (std::size_t i = 0; i < term.effect.unknowns.size(); ++i) {
      averaged.push_back(fitted.fit.estimates[term.first + i].best());
    }
    const auto first = describeImplausible(term, averaged);
    const auto sentence = first ? first : describeImplausible(term, term.values(fitted.fit.unknowns));
    if (sentence && term.requested) {
      findings.push_back(makeFinding("set-up", term.label(), FindingLevel::stop, *sentence, fitted.measurements));
    }
  }
}

/// The term of a label with the catalogue's effect; absent for other effects.
std::optional<Term> termOf(const std::string& label) {
  const std::size_t at = label.find('@');
  for (const Effect& effect : allEffects()) {
    if (at != std::string::npos && label.substr(0, at) == effect.name) {
      return Term{effect, 0, label.substr(at + 1)};
    }
  }
  return std::nullopt;
}

/// Whether the captures tell no angle of a camera's rotation.
bool isTurnUnknown(const StoredResult& result, const Term& camera) {
  return std::all_of(camera.effect.unknowns.begin(), camera.effect.unknowns.end(), [&](const Unknown& angle) {
    const auto found = result.learned.find(fmt::format("{}.{}", camera.label(), angle.name));
    return found != result.learned.end() && found->second < threshold::learned;
  });
}

} // namespace

std::optional<std::string> describeImplausible(const Term& term, std::span<const double> values) {
  return term.effect.name == effectName::jointOffset      ? describeFarOffset(term, values.front())
         : term.effect.name == effectName::cameraRotation ? describeFarTurn(term, values)
                                                          : std::nullopt;
}

std::optional<std::string> describeImpossibleError(const FittedModel& fitted) {
  const RejectedMeasurements& rejected = fitted.fit.rejected;
  const bool areFew = rejected.share() < threshold::manyRejected;
  const double distance = areFew ? rejected.keptPx : rejected.presentPx;
  const ReadingErrors& readings = areFew ? rejected.keptReadings : fitted.fit.readings;
  const bool isFar = fitted.measurements.cornerCount > 0 && distance > impossibleDistance(fitted.measurements);
  if (!isFar && !areImpossible(readings, fitted.measurements, fitted.fit.noise)) {
    return std::nullopt;
  }
  return fmt::format(
      "the predictions are {} off, and no robot is so wrong{}: check the robot's model, on which links the "
      "cameras, boards and markers are, and the measurements",
      isFar ? fmt::format("{:.0f} px", distance) : formatSizes(readings),
      areFew ? "" : "; " + formatRejected(rejected));
}

std::vector<Finding> listImpossible(const FittedModel& fitted) {
  std::vector<Finding> findings;
  if (auto error = describeImpossibleError(fitted)) {
    findings.push_back(makeFinding("set-up", "unknown", FindingLevel::stop, *std::move(error), fitted.measurements));
  }
  addGrossNoise(fitted, findings);
  addImplausibleValues(fitted, findings);
  return findings;
}

std::vector<std::string> listImplausible(const std::map<std::string, double>& values) {
  std::set<std::string> labels;
  for (const auto& [name, value] : values) {
    labels.insert(name.substr(0, name.rfind('.')));
  }
  std::vector<std::string> sentences;
  for (const std::string& label : labels) {
    const std::optional<Term> term = termOf(label);
    std::vector<double> numbers;
    for (std::size_t i = 0; term && i < term->effect.unknowns.size(); ++i) {
      const auto found = values.find(fmt::format("{}.{}", label, term->effect.unknowns[i].name));
      numbers.push_back(found == values.end() ? 0 : found->second);
    }
    if (auto sentence = term ? describeImplausible(*term, numbers) : std::nullopt) {
      sentences.push_back(*std::move(sentence));
    }
  }
  return sentences;
}

std::vector<std::string> listReasonsAgainstUse(const StoredResult& result) {
  std::vector<std::string> reasons = result.reasons;
  if (!result.usable && reasons.empty()) { // of an older version
    reasons.push_back(result.sentence.empty() ? "the verdict is do-not-use" : result.sentence);
  }
  if (result.usable) {
    for (const std::string& label : result.terms) {
      const std::optional<Term> term = termOf(label);
      const bool isCamera = term && term->effect.name == effectName::cameraRotation;
      if (isCamera && !result.hasReasons && isTurnUnknown(result, *term)) {
        reasons.push_back(fmt::format("how camera {} is turned cannot be learned from its captures", term->placeName));
      }
    }
    const std::vector<std::string> far = listImplausible(result.values);
    reasons.insert(reasons.end(), far.begin(), far.end());
  }
  return reasons;
}

} // namespace naocal
