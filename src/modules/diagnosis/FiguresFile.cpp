#include "diagnosis/FiguresFile.hpp"

#include "diagnosis/evidence/Aliasing.hpp"
#include "diagnosis/views/Figures.hpp"
#include "io/JsonWriter.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

using Json = nlohmann::json;

namespace {

Json posesJson(const CaptureIndex& taken) {
  Json result = Json::array();
  for (const CaptureIndex::Pose& pose : taken.poses) {
    result.push_back({{"set", pose.set}, {"name", pose.name}, {"pictures", pose.pictures}});
  }
  return result;
}

Json picturesJson(const CaptureIndex& taken) {
  Json result = Json::array();
  for (const CaptureIndex::Picture& picture : taken.pictures) {
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
      numbers.push_back(roundToDigits(alike));
    }
  }
  for (const CandidateFinding& taken : diagnosis.ranking) {
    const auto one = std::find(labels.begin(), labels.end(), taken.term.label());
    if (one == labels.end() || taken.state != CandidateState::present) {
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
                       {"correlation", roundToDigits(alike)},
                       {"timesTheData", roundToDigits(evidenceToSeparate(alike) / taken.evidence.likelihoodRatio)}});
    }
  }
  return {{"candidates", labels}, {"correlations", std::move(rows)}, {"confusable", std::move(pairs)}};
}

Json signatureJson(const EffectSignature& view, const Effect& effect) {
  Json size = Json::object(), pictures = Json::array();
  for (std::size_t i = 0; i < effect.unknowns.size(); ++i) {
    size[effect.unknowns[i].name] = {{"value", roundToDigits(view.size[eigenIndex(i)])},
                                     {"unit", effect.unknowns[i].unit}};
  }
  for (const EffectSignature::Seen& seen : view.pictures) {
    Json corners = Json::array();
    for (const auto& corner : seen.corners.colwise()) {
      corners.push_back(Json::array());
      for (const double number : corner) {
        corners.back().push_back(roundToDigits(number, 3));
      }
    }
    pictures.push_back({{"picture", seen.picture},
                        {"rmsPxBefore", roundToDigits(seen.beforePx)},
                        {"rmsPxAfter", roundToDigits(seen.afterPx)},
                        {"corners", std::move(corners)}});
  }
  return {{"found", view.found},
          {"size", std::move(size)},
          {"rmsPxBefore", roundToDigits(view.beforePx)},
          {"rmsPxAfter", roundToDigits(view.afterPx)},
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
  for (const AddedVariablePoint& point : thinOut(view.points, mostPoints)) {
    result["points"].push_back({{"pose", point.pose ? Json(*point.pose) : Json(nullptr)},
                                {"signature", roundToDigits(point.signature)},
                                {"residual", roundToDigits(point.residual)}});
  }
  return result;
}

/// Recorded drivers with any variation, rounded to four digits of their range.
Json recordedJson(const Figures& figures) {
  Json result = Json::array();
  for (const DriverSeries& driver : figures.recorded) {
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

Json jointCorrectionsJson(const Figures& figures, const Figures::Left& left, std::size_t mostPoints) {
  Json result = Json::array();
  for (const SingleJointCorrection& joint : left.whatIfs) {
    Json points = Json::array();
    for (const JointCorrection& point : thinOut(joint.points, mostPoints)) {
      points.push_back({{"pictures", point.pictures},
                        {"deflection", roundToDigits(point.deflection, 4)},
                        {"sigma", roundToDigits(point.sigma, 3)}});
    }
    result.push_back({{"joint", figures.taken.joints[joint.motor]}, {"points", std::move(points)}});
    if (joint.points.size() > mostPoints) {
      result.back()["of"] = joint.points.size();
    }
  }
  return result;
}

/// Three lengths [m], rounded to the micrometre.
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
                      {"p", roundToDigits(shape.pValue, 3)},
                      {"corners", std::move(corners)}});
  }
  return result;
}

/// Adds the readings that are no corners, each with the picture it was taken with, and their noise; nothing without
/// any.
void addReadingsJson(const Figures::Left& left, std::size_t mostPoints, Json& views) {
  for (const ReadingRecord& record : thinOut(left.readings, mostPoints)) {
    views["readings"].push_back(toJson(record));
    views["readings"].back()["picture"] = record.picture;
  }
  if (!left.readings.empty()) {
    views["readingNoise"] = toJson(left.readingLevels);
  }
}

Json residualViewsJson(const Figures& figures, const Figures::Left& left, std::size_t mostPoints) {
  Json cells = Json::array(), boards = Json::array();
  for (const ResidualField::Cell& cell : left.leftover.cells) {
    cells.push_back({{"camera", figures.taken.pictures[cell.worstPicture].camera},
                     {"u", roundToDigits(cell.u, 4)},
                     {"v", roundToDigits(cell.v, 4)},
                     {"du", roundToDigits(cell.du, 3)},
                     {"dv", roundToDigits(cell.dv, 3)},
                     {"sigma", roundToDigits(cell.sigma, 3)},
                     {"corners", cell.corners},
                     {"worstPicture", cell.worstPicture}});
  }
  for (const ResidualField::Seen& seen : thinOut(left.leftover.boards, mostPoints)) {
    boards.push_back({{"picture", seen.picture},
                      {"board", figures.taken.boards[seen.board]},
                      {"distance", roundToDigits(seen.distance, 4)},
                      {"rmsPx", roundToDigits(seen.rmsPx, 3)}});
  }
  Json views{{"whatIf", jointCorrectionsJson(figures, left, mostPoints)},
             {"boardShapes", shapesJson(figures, left)},
             {"withinPictures", {{"noisePx", left.leftover.noisePx}, {"cells", cells}, {"boards", boards}}}};
  addReadingsJson(left, mostPoints, views);
  return views;
}

/// Adds the recorded drivers of every picture and the residuals of the models: "asGiven" and, after additions,
/// "withSuggested".
void addResidualViewsJson(const Figures& figures, std::size_t mostPoints, Json& file) {
  file["recorded"] = recordedJson(figures);
  file["left"] = {{"asGiven", residualViewsJson(figures, figures.given, mostPoints)}};
  if (!figures.last.whatIfs.empty()) {
    file["left"]["withSuggested"] = residualViewsJson(figures, figures.last, mostPoints);
  }
}

Json causesJson(const std::vector<PartialResidual>& causes, std::size_t mostPoints) {
  Json result = Json::array();
  for (const PartialResidual& cause : causes) {
    Json points = Json::array();
    for (const PartialResidual::Point& point : thinOut(cause.points, mostPoints)) {
      points.push_back({{"pictures", point.pictures},
                        {"over", roundToDigits(point.over)},
                        {"own", roundToDigits(point.own)},
                        {"left", roundToDigits(point.left)},
                        {"sigma", roundToDigits(point.sigma)}});
    }
    result.push_back({{"label", cause.label},
                      {"error", cause.error},
                      {"over", cause.over},
                      {"unit", cause.unit},
                      {"overUnit", cause.overUnit},
                      {"before", roundToDigits(cause.before())},
                      {"after", roundToDigits(cause.after())},
                      {"points", std::move(points)}});
  }
  return result;
}

} // namespace

void addFiguresJson(const Diagnosis& diagnosis, std::size_t mostPoints, Json& file) {
  file["poses"] = posesJson(diagnosis.figures.taken);
  file["pictures"] = picturesJson(diagnosis.figures.taken);
  file["cameras"] = Json::object();
  for (const auto& [camera, size] : diagnosis.figures.taken.cameras) {
    file["cameras"][camera] = {{"width", size[0]}, {"height", size[1]}};
  }
  file["causes"] = causesJson(diagnosis.figures.causes, mostPoints);
  file["aliases"] = aliasesJson(diagnosis);
  addResidualViewsJson(diagnosis.figures, mostPoints, file);
}

void addFiguresJson(const CandidateFinding& finding, std::size_t mostPoints, Json& entry) {
  if (finding.addedVariable) {
    entry["addedVariable"] = addedVariableJson(*finding.addedVariable, finding.term.effect, mostPoints);
  }
  if (finding.imprint) {
    entry["imprint"] = signatureJson(*finding.imprint, finding.term.effect);
  }
}

} // namespace naocal
