#include "report/CurvesData.hpp"

#include "estimation/ModelFile.hpp"
#include "io/Units.hpp"
#include "report/PageValues.hpp"

#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

using nlohmann::json;

namespace {

/// Unit of a driver by its name in expressions, of those that were recorded or else by its kind: "rad" for "q" and
/// "LHipPitch", "Nm" for "tau_LHipPitch".
std::string driverUnit(const JsonCursor& diagnosis, const std::string& driver) {
  static const std::map<std::string, std::string> own{
      {"tau", "Nm"}, {"approach", "1"}, {"T", "°C"}, {"qd", "rad/s"}, {"t", "s"}};
  const auto known = own.find(driver);
  return recordedUnit(diagnosis, driver)
      .value_or(known != own.end()           ? known->second
                : driver.starts_with("tau_") ? "Nm"
                                             : "rad");
}

/// A driver's name in expressions where it may be of any joint: "q" and "tau" of LHipPitch are "LHipPitch" and
/// "tau_LHipPitch".
std::string nameDriver(const std::string& driver, const std::string& joint) {
  return driver == "q" ? joint : driver == "tau" ? "tau_" + joint : driver;
}

/// A model file with the curve's expression as a custom effect and the labels `with`.
json modelFile(const JsonCursor& effect, std::vector<std::string> with) {
  with.push_back(fmt::format("{}@{}", effect.at("name").text(), effect.at("at").text()));
  return modelFileJson(with, {}, json::array({effect.value()}));
}

/// `suggested`: labels of the effects that the model has already.
json curveJson(const JsonCursor& diagnosis, const JsonCursor& curve, const json& suggested) {
  const std::string joint = curve.at("at").text(), driver = curve.at("driver").text();
  const auto about = curve.find("about");
  const auto valueUnit = curve.find("unit");
  const std::string ownUnit = valueUnit ? valueUnit->text() : "rad";
  const auto [shown, size] = displayUnit(about ? ownUnit : recordedUnit(diagnosis, joint).value_or(ownUnit));
  const bool within = about && shown != "°"; // residual within images: board shape or lens, over places there
  const auto [unit, scale] =
      displayUnit(within ? (shown == "px" ? "px" : "m") : driverUnit(diagnosis, nameDriver(driver, joint)));
  const auto effect = curve.find("effect"); // only for joints' curves
  json points = json::array();
  for (const JsonCursor& point : curve.at("curve").elements()) {
    const std::vector<double> values = point.numbers(3, anyNumber, "driver, deflection, standard error");
    points.push_back({scale * values[0], size * values[1], size * values[2]});
  }
  if (points.size() < 2) {
    curve.at("curve").refuse("at least two points");
  }
  return {{"joint", joint},
          {"driver", driver},
          {"what", curve.at("what").text()},
          {"unit", unit},
          {"points", points},
          {"valueUnit", shown},
          {"amplitude", size * curve.at("amplitude").number(anyNumber)},
          {"evidence", curve.at("evidence").number(anyNumber)},
          {"expression", effect ? curve.at("expression").text() : ""},
          {"title", !about          ? fmt::format("deflection of {}", joint)
                    : shown == "mm" ? fmt::format("corners of board {} off along {}", joint, about->text())
                    : shown == "px" ? fmt::format("errors of camera {} along {}", joint, about->text())
                                    : fmt::format("turn of camera {} about its {} axis", joint, about->text())},
          {"model", effect ? modelFile(*effect, suggested.get<std::vector<std::string>>()) : json(nullptr)}};
}

} // namespace

json curvesData(const JsonCursor& diagnosis, const json& suggested) {
  json curves = json::array();
  for (const JsonCursor& curve : diagnosis.at("drivers").elements()) {
    curves.push_back(curveJson(diagnosis, curve, suggested));
  }
  return curves;
}

json mapData(const JsonCursor& diagnosis) {
  json cells = json::array();
  const auto map = diagnosis.find("map");
  for (const JsonCursor& cell : map ? map->elements() : std::vector<JsonCursor>{}) {
    const std::string joint = cell.at("at").text(), driver = cell.at("driver").text();
    cells.push_back({{"joint", joint},
                     {"driver", nameDriver(driver, joint)},
                     {"evidence", cell.at("evidence").number(anyNumber)},
                     {"pValue", cell.at("pValue").number({0, 1, ""})}});
  }
  return cells;
}

} // namespace naocal
