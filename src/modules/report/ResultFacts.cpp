#include "report/ResultFacts.hpp"

#include "calibration/result/Wording.hpp"
#include "io/Units.hpp"
#include "measurements/Witness.hpp"
#include "report/PageValues.hpp"
#include "report/ReadingsData.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

namespace naocal {

namespace {

double numberAt(const JsonCursor& place, const std::string& key) {
  return place.at(key).number({-1e15, 1e15, ""});
}

Fact cornerFact(const JsonCursor& result, std::size_t pictures, const std::optional<DrawingErrors>& drawing) {
  const double rms = numberAt(result, "rmsPx");
  const std::string where =
      fmt::format("rms distance between {:.0f} measured corners in {} pictures and where the result predicts them",
                  numberAt(result, "corners"), pictures);
  if (!drawing) {
    return {fmt::format("{:.2f} px", rms), where + fmt::format(" (median {:.2f} px).", numberAt(result, "medianPx"))};
  }
  return {fmt::format("{:.3g} → {:.2f} px", drawing->rmsPx, rms),
          where + "; the first number is with the robot's drawing alone, boards where they fit best."};
}

/// What one instrument's errors are: its key in a result, its unit, and how they are called.
struct ErrorOf {
  std::string unit; // "m" or "rad"
  std::string what; // "positions that laser measured"
};

Fact readingFact(const JsonCursor& summary, const ErrorOf& of, const ReadingSummary* drawing) {
  const std::string rms = formatSize(numberAt(summary, "rms"), of.unit),
                    where = fmt::format("rms {} between {:.0f} {} and where the result predicts them",
                                        of.unit == "rad" ? "angle" : "distance", numberAt(summary, "points"), of.what);
  if (!drawing) {
    return {rms, where + fmt::format(" (median {}).", formatSize(numberAt(summary, "median"), of.unit))};
  }
  const std::string before = fmt::format("{:.3g}", displayUnit(of.unit).second * drawing->rms);
  return {fmt::format("{} → {}", before, rms),
          where + "; the first number is with the robot's drawing alone, instruments where they fit best."};
}

const ReadingSummary* summaryOf(const std::map<std::string, ReadingSummary>& all, const std::string& name) {
  const auto entry = all.find(name);
  return entry == all.end() ? nullptr : &entry->second;
}

/// One fact per tracker and unit, then contacts.
std::vector<Fact> readingFacts(const JsonCursor& result, const std::optional<DrawingErrors>& drawing) {
  std::vector<Fact> all;
  const auto addTrackers = [&](const char* key, const char* unit, const char* what, const auto& drawn) {
    if (const auto trackers = result.find(key)) {
      for (const auto& [tracker, summary] : trackers->members()) {
        all.push_back(readingFact(summary, {unit, fmt::format("{} that {} measured", what, tracker)},
                                  drawing ? summaryOf(drawn(*drawing), tracker) : nullptr));
      }
    }
  };
  addTrackers("metres", "m", "positions", [](const DrawingErrors& errors) { return errors.readings.metres; });
  addTrackers("radians", "rad", "attitudes", [](const DrawingErrors& errors) { return errors.readings.radians; });
  if (const auto contacts = result.find("contacts")) {
    all.push_back(readingFact(*contacts, {"m", "places that markers touched"},
                              drawing && drawing->readings.contacts ? &*drawing->readings.contacts : nullptr));
  }
  return all;
}

/// Noise of an instrument's readings, or of a distance between places: "0.195 mm (estimated)".
struct NoiseWords {
  std::string name, size, source;
  bool isDistance = false;
};

/// Instruments first, then distances.
std::vector<NoiseWords> readingNoises(const JsonCursor& result) {
  std::vector<NoiseWords> all;
  for (const auto& [instrument, units] : result.at("noise").at("readings").members()) {
    for (const auto& [unit, level] : units.members()) {
      const auto trackers = result.find(unit);
      const bool isDistance = instrument != contactLevel && !(trackers && trackers->find(instrument));
      NoiseWords words{isDistance ? instrument : nameReadings(instrument, unit),
                       formatSize(numberAt(level, "sigma"), unit == "metres" ? "m" : "rad"), level.at("source").text(),
                       isDistance};
      all.insert(isDistance ? all.end()
                            : std::find_if(all.begin(), all.end(), [](const auto& one) { return one.isDistance; }),
                 std::move(words));
    }
  }
  return all;
}

/// "contacts 0.195 mm (estimated), positions of laser 0.3 mm (given)"; equal distances together.
std::string formatReadingNoise(const std::vector<NoiseWords>& noises) {
  std::vector<std::string> parts;
  std::map<std::string, std::vector<std::string>> distances; // by size
  for (const NoiseWords& noise : noises) {
    const std::string size = fmt::format("{} ({})", noise.size, noise.source);
    if (noise.isDistance) {
      distances[size].push_back(noise.name);
    } else {
      parts.push_back(noise.name + " " + size);
    }
  }
  for (const auto& [size, names] : distances) {
    parts.push_back(names.size() == 1 ? fmt::format("the distance {} {}", names.front(), size)
                                      : fmt::format("{} distances between places {}", names.size(), size));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Noise of encoders and joints, and where it is from; of encoders with unknown steps nothing was measured apart.
std::string describeJointNoise(const JsonCursor& noise) {
  const bool hasUnknownSteps = noise.find("unknownSteps").has_value();
  const std::string words = formatJointNoise(
      {.encoder = numberAt(noise, "encoder"), .pose = numberAt(noise, "pose"), .stance = numberAt(noise, "stance")},
      hasUnknownSteps);
  const char* const source = hasUnknownSteps ? ""
                             : noise.at("source").text() == "repeats"
                                 ? ": measured from poses that were taken more than once"
                                 : ": partly assumed, because no pose was taken more than once";
  return words + source + ".";
}

Fact cornerNoiseFact(const JsonCursor& noise) {
  return {fmt::format("{:.2g} px", numberAt(noise, "pixel")),
          "noise of a corner per axis; " + describeJointNoise(noise)};
}

/// Of readings that are no corners; the figure is of the first instrument.
Fact readingNoiseFact(const JsonCursor& result, bool isAlone) {
  const std::vector<NoiseWords> noises = readingNoises(result);
  return {noises.front().size, fmt::format("noise of readings per axis, 1 sigma: {}{}", formatReadingNoise(noises),
                                           isAlone ? "; " + describeJointNoise(result.at("noise")) : ".")};
}

/// The noise floor, and how often noise alone would give such evidence for a missing effect.
Fact misfitFact(const JsonCursor& result) {
  const double p = numberAt(result, "pValue");
  const std::string chance =
      p >= 0.05 ? "the best candidate for more is no more striking than pure noise."
      : p >= 0.001
          ? fmt::format("if nothing were missing, evidence this strong for a cause would turn up once in {:.0f} "
                        "calibrations.",
                        1 / p)
          : "if nothing were missing, evidence this strong for a cause would turn up less than once in 1000 "
            "calibrations.";
  return {formatError(numberAt(result, "noiseFloorPx"), shownErrorUnit(result)), "is the noise floor; " + chance};
}

} // namespace

std::optional<Fact> taskFact(const JsonCursor& document) {
  const auto task = document.find("task");
  if (!task || task->value().is_null()) {
    return std::nullopt;
  }
  return Fact{
      formatSize(numberAt(*task, "bound"), "m"),
      fmt::format("is the bound (99.95 %) of how far off the {} may be, everything that may be missing included; "
                  "the tolerance is {}.",
                  task->at("what").text(), formatSize(numberAt(*task, "tolerance"), "m"))};
}

VerdictWords verdictWords(const JsonCursor& result) {
  const std::string said = result.at("sentence").text(), between = ": ";
  const std::size_t colon = said.find(between);
  if (colon == said.npos) {
    return {said, ""};
  }
  std::string rest = said.substr(colon + between.size());
  if (!rest.empty() && rest.front() >= 'a' && rest.front() <= 'z') {
    rest.front() = static_cast<char>(rest.front() - 'a' + 'A');
  }
  return {said.substr(0, colon) + ".", std::move(rest)};
}

std::vector<Fact> facts(const JsonCursor& result, std::size_t pictures, const std::optional<DrawingErrors>& drawing) {
  const JsonCursor noise = result.at("noise");
  const bool hasReadings = noise.find("readings").has_value();
  std::vector<Fact> all = readingFacts(result, drawing);
  if (pictures > 0) {
    all.insert(all.begin(), cornerFact(result, pictures, drawing));
  }
  if (const auto fact = taskFact(result)) {
    all.push_back(*fact);
  }
  all.push_back(misfitFact(result));
  if (pictures > 0) {
    all.push_back(cornerNoiseFact(noise));
  }
  if (hasReadings) {
    all.push_back(readingNoiseFact(result, pictures == 0));
  }
  return all;
}

} // namespace naocal
