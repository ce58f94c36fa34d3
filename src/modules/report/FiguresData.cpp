#include "report/FiguresData.hpp"

#include "io/Units.hpp"
#include "report/AliasesData.hpp"
#include "report/LeftData.hpp"

#include <nlohmann/json.hpp>
#include <vector>

namespace naocal {

using nlohmann::json;

namespace {

std::vector<JsonPlace> elementsOf(const JsonPlace& object, const std::string& key) {
  const auto list = object.find(key);
  return list ? list->elements() : std::vector<JsonPlace>{};
}

/// One of the entries of a list of the page.
int placeIn(const json& list, const JsonPlace& place) {
  return place.integer(0, static_cast<int>(list.size()) - 1);
}

/// Pictures (capture, camera, pose), poses (set, name, pictures) and cameras (width, height).
void addTaken(const JsonPlace& diagnosis, json& data) {
  data["pictures"] = data["poses"] = json::array();
  data["cameras"] = json::object();
  for (const JsonPlace& picture : elementsOf(diagnosis, "pictures")) {
    data["pictures"].push_back(
        {{"capture", picture.at("capture").integer(0, largestNumber)}, {"camera", picture.at("camera").text()}});
  }
  for (const JsonPlace& pose : elementsOf(diagnosis, "poses")) {
    json pictures = json::array();
    for (const JsonPlace& picture : pose.at("pictures").elements()) {
      pictures.push_back(placeIn(data["pictures"], picture));
      data["pictures"][pictures.back().get<std::size_t>()]["pose"] = data["poses"].size();
    }
    const JsonPlace name = pose.at("name");
    data["poses"].push_back({{"set", pose.at("set").text()},
                             {"name", name.value() == "" ? "–" : name.text()},
                             {"pictures", std::move(pictures)}});
  }
  if (const auto cameras = diagnosis.find("cameras")) {
    for (const auto& [name, camera] : cameras->members()) {
      data["cameras"][name] = {{"width", camera.at("width").integer(1, 100000)},
                               {"height", camera.at("height").integer(1, 100000)}};
    }
  }
}

json addedVariableData(const JsonPlace& candidate, const json& figures) {
  const auto view = candidate.find("addedVariable");
  if (!view) {
    return nullptr;
  }
  const auto [unit, scale] = shownUnit(view->at("unit").text());
  json points = json::array();
  for (const JsonPlace& point : view->at("points").elements()) {
    const JsonPlace pose = point.at("pose");
    points.push_back({pose.value().is_null() ? json(nullptr) : json(placeIn(figures["poses"], pose)),
                      point.at("signature").number(anyNumber) / scale, point.at("residual").number(anyNumber)});
  }
  return {{"of", view->at("of").text()},
          {"unit", unit},
          {"slope", scale * view->at("slope").number(anyNumber)},
          {"sigma", scale * view->at("sigma").number(anyNumber)},
          {"like", view->at("like").text()},
          {"points", points}};
}

json imprintData(const JsonPlace& candidate, const json& figures) {
  const auto view = candidate.find("imprint");
  if (!view) {
    return nullptr;
  }
  json sizes = json::array(), pictures = json::array();
  for (const auto& [name, size] : view->at("size").members()) {
    const auto [unit, scale] = shownUnit(size.at("unit").text());
    sizes.push_back({{"name", name}, {"value", scale * size.at("value").number(anyNumber)}, {"unit", unit}});
  }
  for (const JsonPlace& picture : view->at("pictures").elements()) {
    json corners = json::array();
    for (const JsonPlace& corner : picture.at("corners").elements()) {
      corners.push_back(corner.numbers(6, anyNumber, "u, v, shift before, shift after refitting"));
    }
    pictures.push_back({{"picture", placeIn(figures["pictures"], picture.at("picture"))},
                        {"before", picture.at("rmsPxBefore").number(anyNumber)},
                        {"after", picture.at("rmsPxAfter").number(anyNumber)},
                        {"corners", std::move(corners)}});
  }
  return {{"found", view->at("found").boolean()},
          {"sizes", std::move(sizes)},
          {"before", view->at("rmsPxBefore").number(anyNumber)},
          {"after", view->at("rmsPxAfter").number(anyNumber)},
          {"imitator", view->at("imitator").text()},
          {"pictures", std::move(pictures)}};
}

} // namespace

void addFigures(const JsonPlace& diagnosis, json& data) {
  addTaken(diagnosis, data);
  data["aliases"] = aliasesData(diagnosis);
  addLeft(diagnosis, data);
}

void addFigures(const JsonPlace& entry, const json& figures, json& candidate) {
  candidate["added"] = addedVariableData(entry, figures);
  candidate["imprint"] = imprintData(entry, figures);
}

} // namespace naocal
