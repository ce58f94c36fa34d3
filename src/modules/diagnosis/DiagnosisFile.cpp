#include "diagnosis/DiagnosisFile.hpp"

#include "diagnosis/Diagnosis.hpp"
#include "diagnosis/DiagnosisWording.hpp"
#include "diagnosis/OwnEffect.hpp"
#include "diagnosis/evidence/Aliasing.hpp"
#include "diagnosis/views/Figures.hpp"
#include "io/JsonWriter.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace naocal {

/// What the diagnosis file holds for figures: numbers with as many digits as a figure can show.
///
/// `mostPoints`: of the points of one figure; where there are more, "of" says how many.
///
/// Adds poses, pictures and cameras, and how much alike candidates are, with each pair that the captures cannot tell
/// apart how many times as much data could.
void addFigures(const Diagnosis& diagnosis, std::size_t mostPoints, nlohmann::json& file);
/// Adds a candidate's figures.
void addFigures(const CandidateFinding& finding, std::size_t mostPoints, nlohmann::json& entry);

/// Adds what was recorded at every picture, and what the models leave over: "asGiven" and, where something was added,
/// "withSuggested". `mostPoints` as of `addFigures`.
void addLeft(const Figures& figures, std::size_t mostPoints, nlohmann::json& file);

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

using Json = nlohmann::json;

namespace {

Json posesJson(const Taken& taken) {
  Json result = Json::array();
  for (const Taken::Pose& pose : taken.poses) {
    result.push_back({{"set", pose.set}, {"name", pose.name}, {"pictures", pose.pictures}});
  }
  return result;
}

Json picturesJson(const Taken& taken) {
  Json result = Json::array();
  for (const Taken::Picture& picture : taken.pictures) {
    result.push_back({{"capture", picture.capture}, {"camera", picture.camera}});
  }
  return result;
}

Json aliasesJson(const Diagnosis& diagnosis) {
  const std::vector<std::string>& labels = diagnosis.figures.aliases.labels;
  Json rows = Json::array(), pairs = Json::array();
  for (const auto& row : diagnosis.figures.aliases.correlations.rowwise()) {
    Json& numbers = rows.emplace_back(Json::array());
    for (const double alike : row) {
      numbers.push_back(shortened(alike));
    }
  }
  for (const CandidateFinding& taken : diagnosis.ranking) {
    const auto one = std::find(labels.begin(), labels.end(), taken.term.label());
    if (one == labels.end() || taken.state != State::present) {
      continue;
    }
    for (const std::string& equivalent : taken.equivalent) {
      const auto other = std::find(labels.begin(), labels.end(), equivalent);
      if (other == labels.end()) {
        continue;
      }
      const double alike = diagnosis.figures.aliases.correlations(one - labels.begin(), other - labels.begin());
      pairs.push_back({{"taken", *one},
                       {"other", equivalent},
                       {"correlation", shortened(alike)},
                       {"timesTheData", shortened(evidenceToTell(alike) / taken.evidence.likelihoodRatio)}});
    }
  }
  return {{"candidates", labels}, {"correlations", std::move(rows)}, {"confusable", std::move(pairs)}};
}

Json imprintJson(const Imprint& view, const Effect& effect) {
  Json size = Json::object(), pictures = Json::array();
  for (std::size_t i = 0; i < effect.unknowns.size(); ++i) {
    size[effect.unknowns[i].name] = {{"value", shortened(view.size[at(i)])}, {"unit", effect.unknowns[i].unit}};
  }
  for (const Imprint::Seen& seen : view.pictures) {
    Json corners = Json::array();
    for (const auto& corner : seen.corners.colwise()) {
      corners.push_back(Json::array());
      for (const double number : corner) {
        corners.back().push_back(shortened(number, 3));
      }
    }
    pictures.push_back({{"picture", seen.picture},
                        {"rmsPxBefore", shortened(seen.beforePx)},
                        {"rmsPxAfter", shortened(seen.afterPx)},
                        {"corners", std::move(corners)}});
  }
  return {{"found", view.found},
          {"size", std::move(size)},
          {"rmsPxBefore", shortened(view.beforePx)},
          {"rmsPxAfter", shortened(view.afterPx)},
          {"imitator", view.imitator},
          {"pictures", std::move(pictures)}};
}

Json addedVariableJson(const AddedVariable& view, const Effect& effect, std::size_t mostPoints) {
  const bool one = effect.unknowns.size() == 1;
  Json result{{"of", one ? effect.unknowns.front().name : "size"},
              {"unit", one ? effect.unknowns.front().unit : "1"},
              {"slope", view.slope},
              {"sigma", view.sigma},
              {"like", view.like},
              {"points", Json::array()}};
  if (view.points.size() > mostPoints) {
    result["of"] = view.points.size();
  }
  for (const PoseTestimony& point : thinned(view.points, mostPoints)) {
    result["points"].push_back({{"pose", point.pose ? Json(*point.pose) : Json(nullptr)},
                                {"signature", shortened(point.signature)},
                                {"residual", shortened(point.residual)}});
  }
  return result;
}

} // namespace

void addFigures(const Diagnosis& diagnosis, std::size_t mostPoints, Json& file) {
  file["poses"] = posesJson(diagnosis.figures.taken);
  file["pictures"] = picturesJson(diagnosis.figures.taken);
  file["cameras"] = Json::object();
  for (const auto& [camera, size] : diagnosis.figures.taken.cameras) {
    file["cameras"][camera] = {{"width", size[0]}, {"height", size[1]}};
  }
  file["aliases"] = aliasesJson(diagnosis);
  addLeft(diagnosis.figures, mostPoints, file);
}

void addFigures(const CandidateFinding& finding, std::size_t mostPoints, Json& entry) {
  if (finding.addedVariable) {
    entry["addedVariable"] = addedVariableJson(*finding.addedVariable, finding.term.effect, mostPoints);
  }
  if (finding.imprint) {
    entry["imprint"] = imprintJson(*finding.imprint, finding.term.effect);
  }
}

using Json = nlohmann::json;

namespace {

/// What was recorded at every picture and varied; four digits of what it varied by.
Json recordedJson(const Figures& figures) {
  Json result = Json::array();
  for (const DriverValues& driver : figures.recorded) {
    Json values = Json::array();
    const auto [least, most] = std::minmax_element(driver.atPicture.begin(), driver.atPicture.end());
    const double scale = std::pow(10.0, 4 - std::floor(std::log10(*most - *least)));
    for (const double value : driver.atPicture) {
      values.push_back(std::round(value * scale) / scale);
    }
    result.push_back({{"driver", driver.name}, {"what", driver.what}, {"unit", driver.unit}, {"values", values}});
    if (driver.motor) {
      result.back()["at"] = figures.taken.joints[*driver.motor];
    }
  }
  return result;
}

Json whatIfsJson(const Figures& figures, const Figures::Left& left, std::size_t mostPoints) {
  Json result = Json::array();
  for (const WhatIfs& joint : left.whatIfs) {
    Json points = Json::array();
    for (const WhatIf& point : thinned(joint.points, mostPoints)) {
      points.push_back({{"pictures", point.pictures},
                        {"deflection", shortened(point.deflection, 4)},
                        {"sigma", shortened(point.sigma, 3)}});
    }
    result.push_back({{"joint", figures.taken.joints[joint.motor]}, {"points", std::move(points)}});
    if (joint.points.size() > mostPoints) {
      result.back()["of"] = joint.points.size();
    }
  }
  return result;
}

/// Three numbers [m] to the micrometre.
Json micrometres(const Eigen::Vector3d& metres) {
  Json result = Json::array();
  for (const double value : metres) {
    result.push_back(std::round(value * 1e6) / 1e6);
  }
  return result;
}

Json shapesJson(const Figures& figures, const Figures::Left& left) {
  Json result = Json::array();
  for (const BoardShape& shape : left.shapes) {
    Json corners = Json::array();
    for (const BoardShape::Corner& corner : shape.corners) {
      corners.push_back({{"id", corner.id},
                         {"place", micrometres(corner.place)},
                         {"off", micrometres(corner.off)},
                         {"sigma", micrometres(corner.sigma)}});
    }
    result.push_back({{"board", figures.taken.boards[shape.board]},
                      {"p", shortened(shape.pValue, 3)},
                      {"corners", std::move(corners)}});
  }
  return result;
}

Json leftJson(const Figures& figures, const Figures::Left& left, std::size_t mostPoints) {
  Json cells = Json::array(), boards = Json::array();
  for (const Leftover::Cell& cell : left.leftover.cells) {
    cells.push_back({{"camera", figures.taken.pictures[cell.worstPicture].camera},
                     {"u", shortened(cell.u, 4)},
                     {"v", shortened(cell.v, 4)},
                     {"du", shortened(cell.du, 3)},
                     {"dv", shortened(cell.dv, 3)},
                     {"sigma", shortened(cell.sigma, 3)},
                     {"corners", cell.corners},
                     {"worstPicture", cell.worstPicture}});
  }
  for (const Leftover::Seen& seen : thinned(left.leftover.boards, mostPoints)) {
    boards.push_back({{"picture", seen.picture},
                      {"board", figures.taken.boards[seen.board]},
                      {"distance", shortened(seen.distance, 4)},
                      {"rmsPx", shortened(seen.rmsPx, 3)}});
  }
  return {{"whatIf", whatIfsJson(figures, left, mostPoints)},
          {"boardShapes", shapesJson(figures, left)},
          {"withinPictures", {{"noisePx", left.leftover.noisePx}, {"cells", cells}, {"boards", boards}}}};
}

} // namespace

void addLeft(const Figures& figures, std::size_t mostPoints, Json& file) {
  file["recorded"] = recordedJson(figures);
  file["left"] = {{"asGiven", leftJson(figures, figures.given, mostPoints)}};
  if (!figures.last.whatIfs.empty()) {
    file["left"]["withSuggested"] = leftJson(figures, figures.last, mostPoints);
  }
}

} // namespace naocal
