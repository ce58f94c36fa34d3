#include "report/ReadingsData.hpp"

#include "io/Units.hpp"
#include "measurements/Witness.hpp"
#include "report/PageValues.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace naocal {

using nlohmann::json;

namespace {

constexpr Range anywhere{-1e6, 1e6, "m"}, turns{-10, 10, "rad"}, spread{0, 1e6, ""};

using Triple = std::vector<double>;

Triple differenceOf(const JsonCursor& predicted, const Triple& measured, double scale) {
  Triple result = predicted.numbers(3, anywhere, "x, y and z");
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = roundToDecimals(scale * (result[i] - measured[i]), 4);
  }
  return result;
}

Triple scaledTurn(const JsonCursor& turn, double scale) {
  Triple result = turn.numbers(3, turns, "a rotation vector");
  for (double& value : result) {
    value = roundToDecimals(scale * value, 5);
  }
  return result;
}

/// The series of an instrument and a unit, added if it is new.
json& seriesOf(json& all, const JsonCursor& noise, const std::string& instrument, const std::string& unit) {
  const std::string title = nameReadings(instrument, unit);
  const auto known = std::find_if(all.begin(), all.end(), [&](const json& one) { return one["title"] == title; });
  if (known != all.end()) {
    return *known;
  }
  const auto [shown, scale] = displayUnit(unit == "metres" ? "m" : "rad");
  const JsonCursor level = noise.at(instrument).at(unit);
  all.push_back({{"title", title},
                 {"unit", shown},
                 {"sigma", scale * level.at("sigma").number(spread)},
                 {"given", level.at("source").text() == "given"},
                 {"isPlace", unit == "metres"},
                 {"points", json::array()}});
  return all.back();
}

json readingsData(const std::vector<JsonCursor>& readings, const JsonCursor& noise,
                  const std::function<std::size_t(std::size_t)>& pictureOf) {
  json all = json::array();
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const JsonCursor& reading = readings[i];
    const std::string instrument = reading.at("instrument").text();
    const Triple measured = reading.at("measured").numbers(3, anywhere, "x, y and z");
    const auto place = reading.find("place"), turn = reading.find("turn");
    json point{{"of", pictureOf(i)},
               {"target", reading.at("target").text()},
               {"place", place ? place->text() : ""},
               {"at", measured}};
    if (turn) {
      json turned = point;
      const double scale = displayUnit("rad").second;
      turned["reported"] = scaledTurn(turn->at("predicted"), scale);
      turned["fitted"] = scaledTurn(turn->at("fitted"), scale);
      seriesOf(all, noise, instrument, "radians")["points"].push_back(std::move(turned));
    }
    const double scale = displayUnit("m").second;
    point["reported"] = differenceOf(reading.at("predicted"), measured, scale);
    point["fitted"] = differenceOf(reading.at("fitted"), measured, scale);
    seriesOf(all, noise, instrument, "metres")["points"].push_back(std::move(point));
  }
  std::sort(all.begin(), all.end(), [](const json& a, const json& b) {
    return std::pair{!a["isPlace"], a["title"]} < std::pair{!b["isPlace"], b["title"]};
  });
  return all;
}

/// A kind of measurement: where its errors stand in a list of errors, and how it is called and shown.
struct MeasuredKind {
  std::vector<std::string> path; // "metres", "laser"
  std::string title, unit;
  double scale = 1;
  std::optional<double> noise; // of a whole error vector [shown unit]
};

/// What noise of `sigma` per axis leaves of a vector of three components, as rms.
double lengthOfNoise(double sigma) {
  return std::sqrt(3.0) * sigma;
}

std::vector<MeasuredKind> kindsIn(const JsonCursor& errors, const std::optional<JsonCursor>& noise) {
  std::vector<MeasuredKind> kinds;
  if (errors.find("pixels")) {
    kinds.push_back({{"pixels"}, "corners", "px", 1, {}});
  }
  const auto addKind = [&](std::vector<std::string> path, const std::string& instrument, const std::string& unit) {
    const auto [shown, scale] = displayUnit(unit == "metres" ? "m" : "rad");
    std::optional<double> alone;
    if (noise) {
      alone = lengthOfNoise(scale * noise->at(instrument).at(unit).at("sigma").number(spread));
    }
    kinds.push_back({std::move(path), nameReadings(instrument, unit), shown, scale, alone});
  };
  for (const char* unit : {"metres", "radians"}) {
    if (const auto trackers = errors.find(unit)) {
      for (const auto& [tracker, ignored] : trackers->members()) {
        addKind({unit, tracker}, tracker, unit);
      }
    }
  }
  if (errors.find("contacts")) {
    addKind({"contacts"}, contactLevel, "metres");
  }
  return kinds;
}

std::optional<JsonCursor> placeOf(const std::optional<JsonCursor>& errors, const MeasuredKind& kind) {
  std::optional<JsonCursor> place = errors;
  for (const std::string& key : kind.path) {
    place = place ? place->find(key) : std::nullopt;
  }
  return place;
}

json rmsAt(const std::optional<JsonCursor>& errors, const MeasuredKind& kind) {
  const auto place = placeOf(errors, kind);
  return place ? json(kind.scale * place->at("rms").number(spread)) : json(nullptr);
}

} // namespace

std::string nameReadings(const std::string& instrument, const std::string& unit) {
  return instrument == contactLevel ? instrument
                                    : fmt::format("{} of {}", unit == "metres" ? "positions" : "attitudes", instrument);
}

json readingsOfResult(const JsonCursor& result) {
  const auto readings = result.find("readings");
  return readings ? readingsData(readings->elements(), result.at("noise").at("readings"),
                                 [](std::size_t index) { return index; })
                  : json::array();
}

json readingsOfPictures(const JsonCursor& residuals, std::size_t pictures) {
  const auto readings = residuals.find("readings");
  if (!readings) {
    return json::array();
  }
  const std::vector<JsonCursor> all = readings->elements();
  return readingsData(all, residuals.at("readingNoise"), [&](std::size_t index) {
    return static_cast<std::size_t>(all[index].at("picture").integer(0, static_cast<int>(pictures) - 1));
  });
}

json comparedKindsData(const JsonCursor& comparison) {
  json all = json::array();
  const JsonCursor nominal = comparison.at("nominal");
  if (const int corners = comparison.at("corners").integer(0, maxInteger); corners > 0) {
    all.push_back({{"title", "corners"},
                   {"unit", "px"},
                   {"count", corners},
                   {"rms", comparison.at("rmsPx").number(spread)},
                   {"median", comparison.at("medianPx").number(spread)},
                   {"nominal", nominal.at("rmsPx").number(spread)}});
  }
  for (const MeasuredKind& kind : kindsIn(comparison, std::nullopt)) {
    const auto place = placeOf(comparison, kind);
    all.push_back({{"title", kind.title},
                   {"unit", kind.unit},
                   {"count", place->at("points").integer(0, maxInteger)},
                   {"rms", rmsAt(comparison, kind)},
                   {"median", kind.scale * place->at("median").number(spread)},
                   {"nominal", rmsAt(nominal, kind)}});
  }
  return all;
}

json kindErrorsData(const JsonCursor& diagnosis, const json& suggested) {
  const auto fitted = diagnosis.find("fitted"), crossed = diagnosis.find("crossValidated");
  if (!fitted) {
    return json::array();
  }
  const auto left = diagnosis.find("left"), given = left ? left->find("asGiven") : std::nullopt;
  const std::vector<MeasuredKind> kinds =
      kindsIn(fitted->at("given"), given ? given->find("readingNoise") : std::nullopt);
  if (kinds.size() < 2 && !crossed) {
    return json::array();
  }
  json all = json::array();
  for (const MeasuredKind& kind : kinds) {
    json rungs = json::array();
    for (const char* model : {"given", "suggested"}) {
      if (const auto errors = fitted->find(model)) {
        const std::string added = fmt::format("+ {}", fmt::join(suggested.get<std::vector<std::string>>(), ", "));
        rungs.push_back({{"name", model == std::string{"given"} ? "" : added},
                         {"rms", rmsAt(errors, kind)},
                         {"heldOut", rmsAt(crossed ? crossed->find(model) : std::nullopt, kind)}});
      }
    }
    all.push_back({{"title", kind.title},
                   {"unit", kind.unit},
                   {"noise", kind.noise ? json(*kind.noise) : json(nullptr)},
                   {"rungs", std::move(rungs)}});
  }
  return all;
}

} // namespace naocal
