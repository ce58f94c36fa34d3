#include "report/CandidatesData.hpp"

#include "io/Units.hpp"
#include "report/PageValues.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace naocal {

using nlohmann::json;

namespace {

const std::vector<std::string_view>& candidateStates() {
  static const std::vector<std::string_view> all{"present",      "aliased",  "trivial", "absent",
                                                 "inconclusive", "absorbed", "no-data"};
  return all;
}

/// A number; null if the entry lacks it or has none.
json numberOrNull(const JsonCursor& entry, const std::string& key, double scale = 1) {
  const auto place = entry.find(key);
  return !place || place->value().is_null() ? json(nullptr) : json(scale * place->number(anyNumber));
}

json sizesJson(const JsonCursor& unknowns) {
  json sizes = json::array();
  for (const auto& [name, unknown] : unknowns.members()) {
    const auto [unit, scale] = displayUnit(unknown.at("unit").text());
    const auto told = unknown.find("told"); // absent in files of earlier versions
    sizes.push_back({{"name", name},
                     {"unit", unit},
                     {"told", !told || told->boolean()},
                     {"value", numberOrNull(unknown, "value", scale)},
                     {"sigma", numberOrNull(unknown, "sigma", scale)},
                     {"detectable", numberOrNull(unknown, "minimalDetectable", scale)}});
  }
  return sizes;
}

json addedVariableData(const JsonCursor& candidate, const json& figures) {
  const auto view = candidate.find("addedVariable");
  if (!view) {
    return nullptr;
  }
  const auto [unit, scale] = displayUnit(view->at("unit").text());
  constexpr double undetermined = 1e15; // sigma of a slope that these poses do not move
  const JsonCursor sigma = view->at("sigma");
  if (sigma.value().is_null() || sigma.value() > undetermined) {
    return nullptr;
  }
  json points = json::array();
  for (const JsonCursor& point : view->at("points").elements()) {
    const JsonCursor pose = point.at("pose");
    points.push_back({pose.value().is_null() ? json(nullptr) : json(indexIn(figures["poses"], pose)),
                      point.at("signature").number(anyNumber) / scale, point.at("residual").number(anyNumber)});
  }
  return {{"of", view->at("of").text()},
          {"unit", unit},
          {"slope", scale * view->at("slope").number(anyNumber)},
          {"sigma", scale * view->at("sigma").number(anyNumber)},
          {"like", view->at("like").text()},
          {"points", points}};
}

/// Null without corners: other readings have no picture to draw them in.
json signatureData(const JsonCursor& candidate, const json& figures) {
  const auto view = candidate.find("imprint");
  if (!view) {
    return nullptr;
  }
  json sizes = json::array(), pictures = json::array();
  for (const auto& [name, size] : view->at("size").members()) {
    const auto [unit, scale] = displayUnit(size.at("unit").text());
    sizes.push_back({{"name", name}, {"value", scale * size.at("value").number(anyNumber)}, {"unit", unit}});
  }
  for (const JsonCursor& picture : view->at("pictures").elements()) {
    if (picture.at("corners").elements().empty()) {
      continue;
    }
    json corners = json::array();
    for (const JsonCursor& corner : picture.at("corners").elements()) {
      corners.push_back(corner.numbers(6, anyNumber, "u, v, shift before, shift after refitting"));
    }
    pictures.push_back({{"picture", indexIn(figures["pictures"], picture.at("picture"))},
                        {"before", picture.at("rmsPxBefore").number(anyNumber)},
                        {"after", picture.at("rmsPxAfter").number(anyNumber)},
                        {"corners", std::move(corners)}});
  }
  if (pictures.empty()) {
    return nullptr;
  }
  return {{"found", view->at("found").boolean()},
          {"sizes", std::move(sizes)},
          {"before", view->at("rmsPxBefore").number(anyNumber)},
          {"after", view->at("rmsPxAfter").number(anyNumber)},
          {"imitator", view->at("imitator").text()},
          {"pictures", std::move(pictures)}};
}

/// Refuses the numbers of a tested candidate that are absent; a suspected set-up has none.
void requireNumbers(const JsonCursor& entry) {
  if (entry.find("evidence")) {
    for (const char* key : {"power", "keptFraction", "pValue", "predictedChi2Drop", "chi2Drop", "heldOutPxBefore",
                            "heldOutPxAfter", "step", "plausible"}) {
      entry.at(key);
    }
  }
}

json candidateJson(const JsonCursor& entry, const json& figures, const ErrorUnit& errors) {
  requireNumbers(entry);
  const std::size_t state = entry.at("state").wordIndex(candidateStates());
  const auto shown = entry.find("shown"); // absent in files of earlier versions
  const auto why = entry.find("why"), step = entry.find("step"), plausible = entry.find("plausible");
  return {{"label", entry.at("effect").text() + "@" + entry.at("at").text()},
          {"state", std::string{candidateStates()[state]}},
          {"shown", std::string{candidateStates()[shown ? shown->wordIndex(candidateStates()) : state]}},
          {"why", why ? why->text() : ""},
          {"setUp", !entry.find("evidence")},
          {"errorUnit", errors.name},
          {"sizes", sizesJson(entry.at("unknowns"))},
          {"power", numberOrNull(entry, "power")},
          {"kept", numberOrNull(entry, "keptFraction")},
          {"evidence", numberOrNull(entry, "evidence")},
          {"pValue", numberOrNull(entry, "pValue")},
          {"predictedDrop", numberOrNull(entry, "predictedChi2Drop")},
          {"realDrop", numberOrNull(entry, "chi2Drop")},
          {"before", numberOrNull(entry, "heldOutPxBefore", errors.perPx)},
          {"after", numberOrNull(entry, "heldOutPxAfter", errors.perPx)},
          {"step", step ? step->integer(0, maxInteger) : 0},
          {"plausible", !plausible || plausible->boolean()},
          {"equivalent", entry.at("equivalent").texts()},
          {"added", addedVariableData(entry, figures)},
          {"imprint", signatureData(entry, figures)}};
}

} // namespace

json candidatesData(const JsonCursor& diagnosis, const json& figures, const ErrorUnit& errors) {
  json candidates = json::array();
  for (const JsonCursor& entry : diagnosis.at("ranking").elements()) {
    candidates.push_back(candidateJson(entry, figures, errors));
  }
  return candidates;
}

} // namespace naocal
