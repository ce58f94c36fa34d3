#include "report/EvaluationData.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

namespace naocal {

using nlohmann::json;

namespace {

/// Shares by tolerance, ascending.
std::vector<std::pair<double, double>> byTolerance(const JsonCursor& shares) {
  std::vector<std::pair<double, double>> result;
  for (const auto& [tolerance, part] : shares.members()) {
    result.emplace_back(std::stod(tolerance), part.number({0, 1, ""}));
  }
  std::sort(result.begin(), result.end());
  return result;
}

json sharesOf(const JsonCursor& shares) {
  json result = json::array();
  for (const auto& [tolerance, part] : byTolerance(shares)) {
    result.push_back(part);
  }
  return result;
}

/// Display name of a cell's setting: "boards, 3 poses, both (encoder)".
std::string nameOf(const JsonCursor& cell) {
  const std::string noise = cell.at("noise").text();
  const int samples = cell.at("samples").integer(1, 1000), poses = cell.at("poses").integer(1, 1000);
  std::string name = fmt::format("{}, {} poses, noise: {}", cell.at("feature").text(), poses, noise);
  name += noise == "joint" || noise == "both" ? fmt::format(" ({})", cell.at("jointNoise").text()) : "";
  name += samples > 1 ? fmt::format(", {} samples", samples) : "";
  name += cell.at("errors").text() == "6.5" ? "" : fmt::format(", errors of {} degrees", cell.at("errors").text());
  name += cell.at("legs").text() == "both" ? ", both legs" : "";
  name += cell.at("places").text() == "unknown" ? ", mounts and places unknown" : "";
  return name + (cell.at("chosenBy").text() == "ours" ? "" : ", the thesis's poses");
}

json histogram(const JsonCursor& counts, const JsonCursor& bins) {
  return {{"counts", counts.value()},
          {"first", bins.at("firstDegrees").number({-180, 180, "deg"})},
          {"width", bins.at("widthDegrees").number({0, 180, "deg"})}};
}

/// Groups cells by name, in the file's order; one cell per solver.
std::vector<std::pair<std::string, std::vector<JsonCursor>>> grouped(const std::vector<JsonCursor>& cells,
                                                                     std::string (*name)(const JsonCursor&)) {
  std::vector<std::pair<std::string, std::vector<JsonCursor>>> result;
  for (const JsonCursor& cell : cells) {
    const std::string own = name(cell);
    const auto same = std::find_if(result.begin(), result.end(), [&](const auto& each) { return each.first == own; });
    (same == result.end() ? result.emplace_back(own, std::vector<JsonCursor>{}) : *same).second.push_back(cell);
  }
  return result;
}

json jointsOf(const std::vector<JsonCursor>& cells, const JsonCursor& evaluation) {
  json joints = json::array();
  for (const auto& [joint, before] : cells.front().at("offsetCounts").members()) {
    json solvers = json::array();
    for (const JsonCursor& cell : cells) {
      const std::string solver = cell.at("solver").text();
      const auto errors = cell.find("errorCounts");
      if ((solver == "ours" || solver == "lm") && errors && errors->find(joint)) {
        solvers.push_back(histogram(errors->at(joint), evaluation.at("errorBins")));
        solvers.back()["solver"] = solver;
      }
    }
    joints.push_back(
        {{"name", joint}, {"before", histogram(before, evaluation.at("offsetBins"))}, {"solvers", solvers}});
  }
  return joints;
}

} // namespace

json evaluationData(const JsonCursor& evaluation) {
  const std::vector<JsonCursor> cells = evaluation.at("cells").elements();
  if (cells.empty()) {
    evaluation.at("cells").refuse("at least one cell", "none: nothing was evaluated yet");
  }
  json tables = json::array(), settings = json::array(), tolerances = json::array();
  for (const auto& [table, ofTable] : grouped(cells, [](const JsonCursor& cell) { return cell.at("table").text(); })) {
    json figures = json::array();
    for (const auto& [name, ofSetting] : grouped(ofTable, nameOf)) {
      json solvers = json::array();
      for (const JsonCursor& cell : ofSetting) {
        solvers.push_back({{"solver", cell.at("solver").text()},
                           {"success", sharesOf(cell.at("success"))},
                           {"limit", sharesOf(cell.at("limit"))}});
      }
      figures.push_back({{"name", name}, {"solvers", solvers}, {"thesis", ofSetting.front().at("thesis").value()}});
    }
    tables.push_back({{"name", table == "beyond" ? "beyond the thesis" : table}, {"cells", figures}});
  }
  for (const auto& [name, ofSetting] : grouped(cells, nameOf)) {
    settings.push_back({{"name", name}, {"joints", jointsOf(ofSetting, evaluation)}});
  }
  for (const auto& [tolerance, part] : byTolerance(cells.front().at("success"))) {
    tolerances.push_back(tolerance);
  }
  const auto best = evaluation.find("reproduction");
  const double tolerance = best ? best->at("toleranceDegrees").number({0, 180, "deg"}) : 0.2;
  const int sets = evaluation.at("sets").integer(1, 1'000'000'000);
  return {{"headline", "How often all offsets are found"},
          {"sentence", fmt::format("{} error sets per setting, {} settings; the thesis's figures are drawn at {:.1f}°.",
                                   sets, settings.size(), tolerance)},
          {"facts", json::array()},
          {"warnings", json::array()},
          {"tolerances", tolerances},
          {"thesisTolerance", tolerance},
          {"tables", tables},
          {"settings", settings}};
}

} // namespace naocal
