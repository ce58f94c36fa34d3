#include "diagnose/DiagnosisFile.hpp"

#include "diagnose/FiguresJson.hpp"
#include "diagnose/OwnEffect.hpp"
#include "diagnose/Sentences.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

using Json = nlohmann::json;

namespace {

Json number(double value) { // JSON has no infinity
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json number(const std::optional<double>& value) {
  return value ? number(*value) : Json(nullptr);
}

Json unknowns(const CandidateFinding& finding) {
  Json result = Json::object();
  for (std::size_t i = 0; i < finding.term.effect.unknowns.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const bool known = finding.evidence.estimate.size() > row;
    result[finding.term.effect.unknowns[i].name] = {
        {"value", known ? number(finding.evidence.estimate[row]) : Json(nullptr)},
        {"sigma", known ? number(std::sqrt(finding.evidence.covariance(row, row))) : Json(nullptr)},
        {"told", isTold(finding, i)},
        {"unit", finding.term.effect.unknowns[i].unit},
        {"minimalDetectable",
         i < finding.minimalDetectable.size() ? number(finding.minimalDetectable[i]) : Json(nullptr)}};
  }
  return result;
}

Json rankingEntry(const CandidateFinding& finding, std::size_t mostPoints) {
  Json entry{{"effect", finding.term.effect.name},
             {"at", finding.term.place},
             {"unknowns", unknowns(finding)},
             {"state", nameOf(finding.state)},
             {"power", finding.power},
             {"minimalDetectable",
              finding.minimalDetectable.empty() ? Json(nullptr) : number(finding.minimalDetectable.front())},
             {"keptFraction", finding.evidence.keptFraction},
             {"movedPx", finding.evidence.movedPx},
             {"predictedChi2Drop", finding.evidence.likelihoodRatio},
             {"chi2Drop", number(finding.chi2Drop)},
             {"pValue", finding.evidence.pValue},
             {"likelihoodRatio", finding.evidence.likelihoodRatio},
             {"evidence", number(finding.evidence.bayes)},
             {"step", finding.step},
             {"heldOutPxBefore", number(finding.heldOutBefore)},
             {"heldOutPxAfter", number(finding.heldOutAfter)},
             {"plausible", finding.plausible},
             {"equivalent", finding.equivalent}};
  if (!finding.why.empty()) {
    entry["why"] = finding.why;
  }
  addFigures(finding, mostPoints, entry);
  return entry;
}

Json driver(const DriverFinding& finding) {
  Json coefficients = Json::object();
  for (const Coefficient& coefficient : finding.coefficients) {
    coefficients[coefficient.name] = coefficient.value;
  }
  Json result{{"at", finding.place},         {"driver", finding.driver},  {"what", finding.what},
              {"share", finding.share},      {"evidence", finding.bayes}, {"amplitude", finding.amplitude},
              {"unit", finding.unit},        {"curve", finding.curve},    {"expression", finding.expression},
              {"coefficients", coefficients}};
  if (!finding.about.empty()) {
    result["about"] = finding.about;
  }
  if (!finding.coefficients.empty()) {
    result["effect"] = curveEffect(finding);
  }
  return result;
}

} // namespace

Json diagnosisJson(const Diagnosis& diagnosis, std::size_t mostPoints) {
  Json result{{"format", "naocal-diagnosis"},
              {"version", 1},
              {"verdict", nameOf(diagnosis.verdict)},
              {"sentence", diagnosis.sentence},
              {"lackOfFit",
               {{"statistic", diagnosis.lackOfFit.statistic},
                {"dof", diagnosis.lackOfFit.dof},
                {"pValue", diagnosis.lackOfFit.pValue},
                {"noiseFloorPx", diagnosis.lackOfFit.noiseFloorPx},
                {"rmsPx", diagnosis.rmsPx}}},
              {"alarm", diagnosis.alarm},
              {"poseScatter", diagnosis.scatter},
              {"suggested", diagnosis.suggested},
              {"define", diagnosis.own ? Json::array({Json::parse(diagnosis.own->definition)}) : Json::array()},
              {"seconds", diagnosis.seconds}};
  for (const char* list : {"ranking", "steps", "drivers", "map", "suspicious"}) {
    result[list] = Json::array();
  }
  for (const CandidateFinding& finding : diagnosis.ranking) {
    result["ranking"].push_back(rankingEntry(finding, mostPoints));
  }
  for (const Step& step : diagnosis.steps) {
    result["steps"].push_back({{"added", step.added.empty() ? Json(nullptr) : Json(step.added)},
                               {"dropped", step.dropped},
                               {"rmsPx", step.rmsPx},
                               {"heldOutPx", number(step.heldOutPx)},
                               {"nextPx", number(step.nextPx)},
                               {"noiseFloorPx", step.noiseFloorPx},
                               {"alarm", step.alarm}});
  }
  for (const DriverFinding& finding : diagnosis.drivers) {
    result["drivers"].push_back(driver(finding));
  }
  for (const MapCell& cell : diagnosis.map) {
    result["map"].push_back(
        {{"at", cell.place}, {"driver", cell.driver}, {"evidence", cell.bayes}, {"pValue", cell.pValue}});
  }
  for (const Suspicion& suspicion : diagnosis.suspicious) {
    Json entry{{"why", suspicion.why}};
    if (suspicion.capture) {
      entry["capture"] = *suspicion.capture;
    }
    if (suspicion.odds) {
      entry["odds"] = *suspicion.odds;
    }
    if (suspicion.when) {
      entry["time"] = suspicion.when->time;
      entry["between"] = {suspicion.when->since, suspicion.when->until};
    }
    result["suspicious"].push_back(std::move(entry));
  }
  addFigures(diagnosis, mostPoints, result);
  return result;
}

} // namespace naocal
