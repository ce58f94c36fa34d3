#include "diagnosis/DiagnosisFile.hpp"

#include "calibration/result/ResultFile.hpp"
#include "diagnosis/Diagnosis.hpp"
#include "diagnosis/DiagnosisWording.hpp"
#include "diagnosis/FiguresFile.hpp"
#include "diagnosis/OwnEffect.hpp"
#include "io/FileVersion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

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

Json rankingEntry(const CandidateFinding& finding, const Diagnosis& diagnosis, std::size_t mostPoints) {
  Json entry{{"effect", finding.term.effect.name},
             {"at", finding.term.placeName},
             {"unknowns", unknowns(finding)},
             {"state", toString(finding.state)},
             {"shown", toString(shownState(finding, diagnosis))},
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
  addFiguresJson(finding, mostPoints, entry);
  return entry;
}

Json driverJson(const DriverCurve& finding) {
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
    result["effect"] = curveAsUserEffect(finding);
  }
  return result;
}

Json stepJson(const SelectionStep& step) {
  return {{"added", step.added.empty() ? Json(nullptr) : Json(step.added)},
          {"dropped", step.dropped},
          {"rmsPx", step.rmsPx},
          {"heldOutPx", number(step.heldOutPx)},
          {"nextPx", number(step.nextPx)},
          {"noiseFloorPx", step.noiseFloorPx},
          {"alarm", step.alarm}};
}

Json scoreJson(const DriverScore& cell) {
  return {{"at", cell.place}, {"driver", cell.driver}, {"evidence", cell.bayes}, {"pValue", cell.pValue}};
}

Json setUpJson(const DataAnomaly& anomaly) {
  return {
      {"setUp", anomaly.setUp}, {"why", anomaly.why}, {"question", anomaly.question}, {"odds", number(anomaly.odds)}};
}

/// Errors of the captures that a model was fitted to, joint angles as read, in each kind's own unit.
Json fittedErrorsJson(const CalibrationResult& fit) {
  Json errors = toJson(fit.readings);
  if (!fit.residuals.empty()) {
    errors["pixels"] = {{"rms", fit.rmsPx}, {"median", fit.medianPx}};
  }
  return errors;
}

/// An array with the JSON of every element.
template <typename T> Json listJson(const std::vector<T>& all, const std::function<Json(const T&)>& one) {
  Json result = Json::array();
  for (const T& element : all) {
    result.push_back(one(element));
  }
  return result;
}

} // namespace

Json diagnosisJson(const Diagnosis& diagnosis, std::size_t mostPoints) {
  Json result =
      withFormat("naocal-diagnosis",
                 {{"verdict", toString(diagnosis.verdict)},
                  {"sentence", diagnosis.sentence},
                  {"findings", toJson(diagnosis.findings)},
                  {"lackOfFit",
                   {{"statistic", diagnosis.lackOfFit.statistic},
                    {"dof", diagnosis.lackOfFit.dof},
                    {"pValue", diagnosis.lackOfFit.pValue},
                    {"noiseFloorPx", diagnosis.lackOfFit.noiseFloorPx},
                    {"rmsPx", diagnosis.rmsPx}}},
                  {"alarm", diagnosis.alarm},
                  {"tentative", diagnosis.isTentative},
                  {"poseScatter", diagnosis.scatter},
                  {"suggested", diagnosis.suggested},
                  {"task", taskJson(diagnosis.fit)},
                  {"undetectable", undetectableJson(diagnosis.fit)},
                  {"define", diagnosis.own ? Json::array({Json::parse(diagnosis.own->definition)}) : Json::array()},
                  {"seconds", diagnosis.seconds}});
  result["ranking"] = listJson<CandidateFinding>(
      diagnosis.ranking, [&](const CandidateFinding& finding) { return rankingEntry(finding, diagnosis, mostPoints); });
  result["setUps"] = Json::array();
  for (auto anomaly = diagnosis.anomalies.rbegin(); anomaly != diagnosis.anomalies.rend(); ++anomaly) {
    if (!anomaly->setUp.empty()) { // stand first
      const std::size_t at = std::min(anomaly->setUp.find('@'), anomaly->setUp.size());
      result["setUps"].insert(result["setUps"].begin(), setUpJson(*anomaly));
      result["ranking"].insert(result["ranking"].begin(),
                               Json{{"effect", anomaly->setUp.substr(0, at)},
                                    {"at", anomaly->setUp.substr(std::min(at + 1, anomaly->setUp.size()))},
                                    {"unknowns", Json::object()},
                                    {"state", "present"},
                                    {"equivalent", Json::array()},
                                    {"why", anomaly->why}});
    }
  }
  if (diagnosis.unit.perPx != 1) {
    result["errorUnit"] = toJson(diagnosis.unit);
  }
  if (!diagnosis.fit.readings.empty()) {
    result["fitted"]["given"] = fittedErrorsJson(diagnosis.fit);
    if (!diagnosis.with.empty()) {
      result["fitted"]["suggested"] = fittedErrorsJson(diagnosis.lastFit);
    }
  }
  result["steps"] = listJson<SelectionStep>(diagnosis.steps, stepJson);
  result["drivers"] = listJson<DriverCurve>(diagnosis.driverCurves, driverJson);
  result["map"] = listJson<DriverScore>(diagnosis.driverScores, scoreJson);
  if (!diagnosis.rivalCurve.empty()) {
    result["rivalCurve"] = diagnosis.rivalCurve;
  }
  result["suspicious"] = suspiciousJson(diagnosis.anomalies);
  addFiguresJson(diagnosis, mostPoints, result);
  return result;
}

} // namespace naocal
