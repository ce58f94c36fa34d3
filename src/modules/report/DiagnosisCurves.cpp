#include "report/DiagnosisCurves.hpp"

#include "io/Units.hpp"
#include "residuals/ModelFile.hpp"

#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

namespace naocal {

using nlohmann::json;

namespace {

/// The unit of a driver by its name in expressions: "rad" for "q" and "LHipPitch", "Nm" for "tau_LHipPitch".
std::string driverUnit(const std::string& driver) {
  static const std::map<std::string, std::string> own{
      {"tau", "Nm"}, {"approach", "1"}, {"T", "°C"}, {"qd", "rad/s"}, {"t", "s"}};
  const auto known = own.find(driver);
  return known != own.end() ? known->second : driver.starts_with("tau_") ? "Nm" : "rad";
}

/// The curve's proposed expression as a model file, beside what else was suggested.
json modelFile(const JsonPlace& effect, std::vector<std::string> with) {
  with.push_back(fmt::format("{}@{}", effect.at("name").text(), effect.at("at").text()));
  return modelJson(with, {}, json::array({effect.value()}));
}

} // namespace

json curveJson(const JsonPlace& curve, const json& suggested) {
  const std::string joint = curve.at("at").text(), driver = curve.at("driver").text();
  const auto about = curve.find("about");
  const auto valueUnit = curve.find("unit");
  const auto [shown, size] = shownUnit(valueUnit ? valueUnit->text() : "rad"); // of what varies
  const bool within = shown != "°"; // pictures: a board's shape or a lens, over places there
  const auto [unit, scale] = shownUnit(within ? (shown == "px" ? "px" : "m") : driverUnit(driver));
  const auto effect = curve.find("effect"); // only joints' curves are written as one
  json points = json::array();
  for (const JsonPlace& point : curve.at("curve").elements()) {
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
          {"title", shown == "mm"   ? fmt::format("corners of board {} off along {}", joint, about->text())
                    : shown == "px" ? fmt::format("errors of camera {} along {}", joint, about->text())
                    : about         ? fmt::format("turn of camera {} about its {} axis", joint, about->text())
                                    : fmt::format("deflection of {}", joint)},
          {"model", effect ? modelFile(*effect, suggested.get<std::vector<std::string>>()) : json(nullptr)}};
}

json mapJson(const JsonPlace& diagnosis) {
  json cells = json::array();
  const auto map = diagnosis.find("map");
  for (const JsonPlace& cell : map ? map->elements() : std::vector<JsonPlace>{}) {
    const std::string joint = cell.at("at").text(), driver = cell.at("driver").text();
    cells.push_back({{"joint", joint},
                     {"driver", driver == "q"     ? joint
                                : driver == "tau" ? "tau_" + joint
                                                  : driver},
                     {"evidence", cell.at("evidence").number(anyNumber)},
                     {"pValue", cell.at("pValue").number({0, 1, ""})}});
  }
  return cells;
}

} // namespace naocal
