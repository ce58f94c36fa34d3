#include "report/DiagnosisData.hpp"

#include "io/Units.hpp"
#include "report/DiagnosisCurves.hpp"
#include "report/DiagnosisSentences.hpp"
#include "report/FiguresData.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

using nlohmann::json;

namespace {

/// A number, or null where the diagnosis has none.
json numberOrNull(const JsonPlace& place, double scale = 1) {
  return place.value().is_null() ? json(nullptr) : json(scale * place.number(anyNumber));
}

json texts(const JsonPlace& list) {
  json result = json::array();
  for (const JsonPlace& text : list.elements()) {
    result.push_back(text.text());
  }
  return result;
}

json sizesJson(const JsonPlace& unknowns) {
  json sizes = json::array();
  for (const auto& [name, unknown] : unknowns.members()) {
    const auto [unit, scale] = shownUnit(unknown.at("unit").text());
    const auto told = unknown.find("told"); // files of earlier versions have none
    sizes.push_back({{"name", name},
                     {"unit", unit},
                     {"told", !told || told->boolean()},
                     {"value", numberOrNull(unknown.at("value"), scale)},
                     {"sigma", numberOrNull(unknown.at("sigma"), scale)},
                     {"detectable", numberOrNull(unknown.at("minimalDetectable"), scale)}});
  }
  return sizes;
}

json candidateJson(const JsonPlace& entry, const json& figures) {
  const auto& states = candidateStates();
  const std::size_t state = entry.at("state").oneOf(states);
  const auto why = entry.find("why");
  json result{{"label", entry.at("effect").text() + "@" + entry.at("at").text()},
              {"state", std::string{states[state]}},
              {"why", why ? why->text() : ""},
              {"sizes", sizesJson(entry.at("unknowns"))},
              {"power", numberOrNull(entry.at("power"))},
              {"kept", numberOrNull(entry.at("keptFraction"))},
              {"evidence", numberOrNull(entry.at("evidence"))},
              {"pValue", numberOrNull(entry.at("pValue"))},
              {"predictedDrop", numberOrNull(entry.at("predictedChi2Drop"))},
              {"realDrop", numberOrNull(entry.at("chi2Drop"))},
              {"before", numberOrNull(entry.at("heldOutPxBefore"))},
              {"after", numberOrNull(entry.at("heldOutPxAfter"))},
              {"step", entry.at("step").integer(0, largestNumber)},
              {"plausible", entry.at("plausible").boolean()},
              {"equivalent", texts(entry.at("equivalent"))}};
  addFigures(entry, figures, result);
  return result;
}

json stepJson(const JsonPlace& step) {
  constexpr Range pixels{0, 1e9, "px"};
  const auto dropped = step.find("dropped");
  return {{"added", step.at("added").value().is_null() ? "" : step.at("added").text()},
          {"dropped", dropped ? texts(*dropped) : json::array()},
          {"rms", step.at("rmsPx").number(pixels)},
          {"heldOut", numberOrNull(step.at("heldOutPx"))},
          {"floor", step.at("noiseFloorPx").number(pixels)},
          {"alarm", step.at("alarm").number({0, 1, ""})}};
}

/// Why something looks wrong, with its capture.
json suspicionJson(const JsonPlace& entry) {
  const std::string why = entry.at("why").text();
  const auto capture = entry.find("capture");
  const std::string name = capture ? fmt::format("capture {}", capture->integer(0, largestNumber)) : "";
  return why.find(name) != why.npos ? why : fmt::format("{} ({})", why, name);
}

} // namespace

json diagnosisData(const JsonPlace& diagnosis) {
  const auto defined = diagnosis.find("define");
  const bool own = defined && !defined->elements().empty(); // the last of what is suggested
  json named = texts(diagnosis.at("suggested"));
  if (own && !named.empty()) {
    named.erase(named.size() - 1);
  }
  json data{{"verdict", std::string{verdicts()[diagnosis.at("verdict").oneOf(verdicts())]}},
            {"headline", verdictHeadline(diagnosis)},
            {"sentence", diagnosis.at("sentence").text()},
            {"floorName", floorName(diagnosis)},
            {"suggested", texts(diagnosis.at("suggested"))},
            {"own", own},
            {"map", mapJson(diagnosis)}};
  addFigures(diagnosis, data);
  const auto list = [&](const char* key, const char* from, const auto& entryJson) {
    data[key] = json::array();
    for (const JsonPlace& entry : diagnosis.at(from).elements()) {
      data[key].push_back(entryJson(entry));
    }
  };
  list("steps", "steps", stepJson);
  list("candidates", "ranking", [&](const JsonPlace& entry) { return candidateJson(entry, data); });
  list("curves", "drivers", [&](const JsonPlace& curve) { return curveJson(curve, named); });
  list("suspicious", "suspicious", suspicionJson);
  const auto next = diagnosis.find("next");
  if (next && !next->value().is_null() && next->at("why").value() != "") { // else nothing is open
    data["next"] = {{"poses", next->at("poses").elements().size()}, {"why", next->at("why").text()}};
  }
  data["facts"] = json::array();
  for (const auto& [figure, sentence] : diagnosisFacts(diagnosis)) {
    data["facts"].push_back({{"figure", figure}, {"sentence", sentence}});
  }
  return data;
}

} // namespace naocal
