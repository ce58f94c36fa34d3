#include "diagnose/FiguresJson.hpp"

#include "diagnose/Alternatives.hpp"
#include "diagnose/LeftJson.hpp"
#include "diagnose/Shortened.hpp"
#include "diagnose/Thinned.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal {

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

} // namespace naocal
