#pragma once

#include "estimation/Residuals.hpp"

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Lengths of error vectors [m] or [rad]: rms = sqrt(mean(|d|^2)).
struct ReadingSummary {
  double rms = 0, mean = 0, median = 0, max = 0;
  std::size_t points = 0;
};
ReadingSummary summarizeLengths(std::vector<double> lengths);

/// Lengths of error vectors of measurements other than corners, one by one.
struct ReadingLengths {
  std::map<std::string, std::vector<double>> metres, radians;                 // by tracker
  std::map<std::string, std::map<std::string, std::vector<double>>> byMarker; // by tracker and marker or frame [m]
  std::vector<double> contacts;                                               // marker to place [m]

  void append(const ReadingLengths& other);
};
ReadingLengths collectLengths(const Measurements& measurements, const std::vector<WitnessResidual>& residuals);

/// Errors of measurements other than corners.
struct ReadingErrors {
  std::map<std::string, ReadingSummary> metres, radians;                 // by tracker
  std::map<std::string, std::map<std::string, ReadingSummary>> byMarker; // by tracker and marker or frame [m]
  std::optional<ReadingSummary> contacts;                                // marker to place [m]

  bool empty() const { return metres.empty() && radians.empty() && !contacts; }
};
ReadingErrors summarizeReadings(const ReadingLengths& lengths);
ReadingErrors summarizeReadings(const Measurements& measurements, const std::vector<WitnessResidual>& residuals);

/// Keys `metres`, `radians`, `byMarker` and `contacts`, as far as there is something to say.
nlohmann::json toJson(const ReadingErrors& errors);

/// Unit in which people read errors that are computed in pixels (keys `*Px`).
struct ErrorUnit {
  std::string name = "px";
  double perPx = 1;
};

/// Pixels; of a set without pictures millimetres of the instrument with the most readings: an error of as many sigmas.
/// Without any measurement, pixels.
ErrorUnit errorUnitOf(const Measurements& measurements, const Noise& noise);
nlohmann::json toJson(const ErrorUnit& unit);

/// Error lengths of all witnesses relative to their noise, as distances of corners that are as far off [px]: per axis
/// and in units of sigma, times `noise.pixel`.
std::vector<double> scaledDistances(const Measurements& measurements, const std::vector<WitnessResidual>& residuals,
                                    const Noise& noise);

/// Distances of all corners [px]; of a set without corners, those of its readings as above.
std::vector<double> collectDistances(const Measurements& measurements, const std::vector<BoardResidual>& corners,
                                     const std::vector<WitnessResidual>& readings, const Noise& noise);

/// For example "0.31 mm (laser)", one after the other.
std::string formatSizes(const ReadingErrors& errors);

} // namespace naocal
