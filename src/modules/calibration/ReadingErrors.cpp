#include "calibration/ReadingErrors.hpp"

#include "math/Angles.hpp"
#include "math/Statistics.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using nlohmann::json;

json summaryJson(const ReadingSummary& summary) {
  return {{"rms", summary.rms},
          {"mean", summary.mean},
          {"median", summary.median},
          {"max", summary.max},
          {"points", summary.points}};
}

json summariesJson(const std::map<std::string, ReadingSummary>& summaries) {
  json result = json::object();
  for (const auto& [name, summary] : summaries) {
    result[name] = summaryJson(summary);
  }
  return result;
}

using Lengths = std::map<std::string, std::vector<double>>;

std::map<std::string, ReadingSummary> summarizeAll(const Lengths& lengths) {
  std::map<std::string, ReadingSummary> result;
  for (const auto& [name, all] : lengths) {
    result[name] = summarizeLengths(all);
  }
  return result;
}

} // namespace

ReadingSummary summarizeLengths(std::vector<double> lengths) {
  ReadingSummary result{.points = lengths.size()};
  if (lengths.empty()) {
    return result;
  }
  const auto count = static_cast<double>(lengths.size());
  for (const double length : lengths) {
    result.rms += length * length / count;
    result.mean += length / count;
    result.max = std::max(result.max, length);
  }
  result.rms = std::sqrt(result.rms);
  result.median = medianOf(std::move(lengths));
  return result;
}

void ReadingLengths::append(const ReadingLengths& other) {
  const auto join = [](auto& all, const auto& further) {
    for (const auto& [name, lengths] : further) {
      all[name].insert(all[name].end(), lengths.begin(), lengths.end());
    }
  };
  join(metres, other.metres);
  join(radians, other.radians);
  for (const auto& [tracker, lengths] : other.byMarker) {
    join(byMarker[tracker], lengths);
  }
  contacts.insert(contacts.end(), other.contacts.begin(), other.contacts.end());
}

ReadingLengths collectLengths(const Measurements& measurements, const std::vector<WitnessResidual>& residuals) {
  ReadingLengths result;
  for (const WitnessResidual& one : residuals) {
    const Witness& witness = *measurements.pictures[one.picture].witnesses[one.witness].witness;
    for (const Witness::Part& part : witness.parts()) {
      const ReadingLevel& level = measurements.levels[part.level];
      const double length = one.residual.segment(part.first, part.count).norm();
      if (level.name == contactLevel) {
        result.contacts.push_back(length);
      } else if (witness.target().empty()) {
        continue; // distances between places are no error of the robot
      } else if (level.unit == ReadingLevel::Unit::radians) {
        result.radians[level.name].push_back(length);
      } else {
        result.metres[level.name].push_back(length);
        result.byMarker[level.name][witness.target()].push_back(length);
      }
    }
  }
  return result;
}

ReadingErrors summarizeReadings(const ReadingLengths& lengths) {
  ReadingErrors errors{summarizeAll(lengths.metres), summarizeAll(lengths.radians), {}, {}};
  for (const auto& [tracker, all] : lengths.byMarker) {
    errors.byMarker[tracker] = summarizeAll(all);
  }
  if (!lengths.contacts.empty()) {
    errors.contacts = summarizeLengths(lengths.contacts);
  }
  return errors;
}

ReadingErrors summarizeReadings(const Measurements& measurements, const std::vector<WitnessResidual>& residuals) {
  return summarizeReadings(collectLengths(measurements, residuals));
}

json toJson(const ReadingErrors& errors) {
  json result = json::object();
  if (!errors.metres.empty()) {
    result["metres"] = summariesJson(errors.metres);
    for (const auto& [tracker, summaries] : errors.byMarker) {
      result["byMarker"][tracker] = summariesJson(summaries);
    }
  }
  if (!errors.radians.empty()) {
    result["radians"] = summariesJson(errors.radians);
  }
  if (errors.contacts) {
    result["contacts"] = summaryJson(*errors.contacts);
  }
  return result;
}

ErrorUnit errorUnitOf(const Measurements& measurements, const Noise& noise) {
  if (measurements.cornerCount > 0) {
    return {};
  }
  std::map<std::size_t, std::size_t> readings;
  for (const ImageObservation& picture : measurements.pictures) {
    for (const WitnessObservation& observation : picture.witnesses) {
      const Witness::Part& part = observation.witness->parts().front();
      readings[part.level] += observation.view ? 1 : 0;
    }
  }
  const auto most = std::max_element(readings.begin(), readings.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == readings.end()) {
    return {};
  }
  const double perAxis = sigmaOf(measurements, noise, most->first) / (std::sqrt(2.0) * noise.pixel);
  return {"mm", 1e3 * std::sqrt(3.0) * perAxis};
}

json toJson(const ErrorUnit& unit) {
  return {{"name", unit.name}, {"perPx", unit.perPx}};
}

std::vector<double> scaledDistances(const Measurements& measurements, const std::vector<WitnessResidual>& residuals,
                                    const Noise& noise) {
  std::vector<double> distances;
  for (const WitnessResidual& one : residuals) {
    for (const Witness::Part& part : measurements.pictures[one.picture].witnesses[one.witness].witness->parts()) {
      const double perAxis =
          one.residual.segment(part.first, part.count).norm() / std::sqrt(static_cast<double>(part.count));
      distances.push_back(std::sqrt(2) * noise.pixel * perAxis / sigmaOf(measurements, noise, part.level));
    }
  }
  return distances;
}

std::vector<double> collectDistances(const Measurements& measurements, const std::vector<BoardResidual>& corners,
                                     const std::vector<WitnessResidual>& readings, const Noise& noise) {
  return measurements.cornerCount > 0 ? collectDistances(corners) : scaledDistances(measurements, readings, noise);
}

std::string formatSizes(const ReadingErrors& errors) {
  std::vector<std::string> sizes;
  for (const auto& [tracker, summary] : errors.metres) {
    sizes.push_back(fmt::format("{:.3g} mm ({})", 1e3 * summary.rms, tracker));
  }
  for (const auto& [tracker, summary] : errors.radians) {
    sizes.push_back(fmt::format("{:.3g}° ({})", degrees(summary.rms), tracker));
  }
  if (errors.contacts) {
    sizes.push_back(fmt::format("{:.3g} mm (contacts)", 1e3 * errors.contacts->rms));
  }
  return fmt::format("{}", fmt::join(sizes, ", "));
}

} // namespace naocal
