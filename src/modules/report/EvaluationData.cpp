#include "report/EvaluationData.hpp"

#include <algorithm>
#include <cmath>
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
  const std::string chosenBy = cell.at("chosenBy").text();
  return name + (chosenBy == "ours"             ? ""
                 : chosenBy == "thesis-program" ? ", its program's poses"
                 : chosenBy == "file"           ? ", poses of a file"
                                                : ", the thesis's poses");
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

/// Whether the histograms of errors show a solver.
bool isDrawn(const std::string& solver) {
  return solver == "ours" || solver == "lm" || solver == "lm-program" || solver == "lm-program-starts";
}

json jointsOf(const std::vector<JsonCursor>& cells, const JsonCursor& evaluation) {
  json joints = json::array();
  for (const auto& [joint, before] : cells.front().at("offsetCounts").members()) {
    json solvers = json::array();
    for (const JsonCursor& cell : cells) {
      const std::string solver = cell.at("solver").text();
      const auto errors = cell.find("errorCounts");
      if (isDrawn(solver) && errors && errors->find(joint)) {
        solvers.push_back(histogram(errors->at(joint), evaluation.at("errorBins")));
        solvers.back()["solver"] = solver;
      }
    }
    joints.push_back(
        {{"name", joint}, {"before", histogram(before, evaluation.at("offsetBins"))}, {"solvers", solvers}});
  }
  return joints;
}

constexpr double programTolerance = 0.2; // of the thesis's program [degrees]

/// Tolerance of the thesis's figures in a table [degrees]: known where its program made it, otherwise the one that
/// meets its figures best.
double thesisTolerance(const std::string& table, double best) {
  return table.ends_with("-program") || table.ends_with("-log") ? programTolerance : best;
}

std::string titleOf(const std::string& table) {
  return table == "beyond"             ? "beyond the thesis"
         : table == "5.6-log"          ? "5.6 as its program made it, three samples (its logs)"
         : table == "5.7-log"          ? "5.7 as its program made it, eight boards (its logs)"
         : table == "5.7-program"      ? "5.7 as its program made it, four boards"
         : table.ends_with("-program") ? table.substr(0, 3) + " as its program made it"
         : table == "files"            ? "with the given files"
                                       : table;
}

/// To four decimals: pages are long.
double rounded(double number) {
  constexpr double decimals = 1e4;
  return std::round(decimals * number) / decimals;
}

/// Maps of residuals on the floor per setting and solver, and the poses' fields of view.
json residualMaps(const std::vector<std::pair<std::string, std::vector<JsonCursor>>>& settings) {
  json maps = json::array();
  for (const auto& [name, ofSetting] : settings) {
    json solvers = json::array(), views, square;
    for (const JsonCursor& cell : ofSetting) {
      const auto residuals = cell.find("residuals");
      const std::string solver = cell.at("solver").text();
      const bool isKnown = std::any_of(solvers.begin(), solvers.end(),
                                       [&](const json& each) { return each["solver"] == solver; }); // of another table
      if (!residuals || isKnown || residuals->at("squares").elements().empty()) {
        continue;
      }
      json squares = json::array();
      for (const JsonCursor& each : residuals->at("squares").elements()) {
        const std::vector<double> numbers = each.numbers(4, anyNumber, "x, y, count and sum");
        squares.push_back({numbers[0], numbers[1], numbers[2], rounded(numbers[3] / std::max(1.0, numbers[2]))});
      }
      solvers.push_back({{"solver", solver}, {"squares", squares}});
      views = residuals->at("fieldsOfView").value();
      square = residuals->at("squareMetres").number({0, 100, "m"});
    }
    if (!solvers.empty()) {
      maps.push_back({{"name", name}, {"solvers", solvers}, {"fieldsOfView", views}, {"square", square}});
    }
  }
  return maps;
}

/// Noiseless failures restarted with exact derivatives; null if there were none.
json restartedFailures(const JsonCursor& evaluation) {
  const auto restarted = evaluation.find("restartedFailures");
  return !restarted ? json()
                    : json{{"failures", restarted->at("failures").integer(1, maxInteger)},
                           {"reached", restarted->at("reached").integer(0, maxInteger)},
                           {"ranOut", restarted->at("ranOut").integer(0, maxInteger)},
                           {"interval", restarted->at("interval").numbers(2, {0, 1, ""}, "low and high")}};
}

} // namespace

json evaluationData(const JsonCursor& evaluation) {
  const std::vector<JsonCursor> cells = evaluation.at("cells").elements();
  if (cells.empty()) {
    evaluation.at("cells").refuse("at least one cell", "none: nothing was evaluated yet");
  }
  const auto best = evaluation.find("reproduction");
  const double bestTolerance = best ? best->at("toleranceDegrees").number({0, 180, "deg"}) : programTolerance;
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
      figures.push_back({{"name", name},
                         {"solvers", solvers},
                         {"thesis", ofSetting.front().at("thesis").value()},
                         {"thesisTolerance", thesisTolerance(table, bestTolerance)}});
    }
    tables.push_back({{"name", titleOf(table)}, {"cells", figures}});
  }
  const auto bySetting = grouped(cells, nameOf);
  for (const auto& [name, ofSetting] : bySetting) {
    settings.push_back({{"name", name}, {"joints", jointsOf(ofSetting, evaluation)}});
  }
  for (const auto& [tolerance, part] : byTolerance(cells.front().at("success"))) {
    tolerances.push_back(tolerance);
  }
  const int sets = evaluation.at("sets").integer(1, 1'000'000'000);
  return {{"headline", "How often all offsets are found"},
          {"sentence", fmt::format("{} error sets per setting, {} settings; the thesis's figures are drawn at {:.1f}°.",
                                   sets, settings.size(), bestTolerance)},
          {"facts", json::array()},
          {"findings", json::array()},
          {"tolerances", tolerances},
          {"tables", tables},
          {"settings", settings},
          {"residualMaps", residualMaps(bySetting)},
          {"restartedFailures", restartedFailures(evaluation)}};
}

} // namespace naocal
