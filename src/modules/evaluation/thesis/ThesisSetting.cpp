#include "evaluation/thesis/ThesisSetting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>

namespace naocal {

namespace {

/// A row of a published table: one noise, a percentage per number of poses.
struct PublishedRow {
  std::string table;
  ThesisFeature feature;
  ThesisSolver solver;
  ThesisNoise noise;
  std::size_t samples;
  std::vector<std::pair<std::size_t, double>> success; // poses, percent
};

std::vector<PublishedRow> publishedRows() {
  using enum ThesisFeature;
  using enum ThesisNoise;
  constexpr auto lm = ThesisSolver::plain, random = ThesisSolver::randomStarts;
  return {{"5.6", grid, lm, none, 1, {{3, 87.02}, {5, 85.90}, {8, 83.94}}},
          {"5.6", grid, lm, pixel, 1, {{3, 86.36}, {5, 84.64}, {8, 83.82}}},
          {"5.6", grid, lm, joint, 1, {{3, 47.26}, {5, 53.74}, {8, 58.30}}},
          {"5.6", grid, lm, both, 1, {{3, 46.56}, {5, 53.38}, {8, 57.32}}},
          {"5.7", boards, lm, none, 1, {{3, 0}, {5, 67.52}, {8, 84.08}}},
          {"5.7", boards, lm, pixel, 1, {{3, 0}, {5, 38.98}, {8, 68.00}}},
          {"5.7", boards, lm, joint, 1, {{3, 0}, {5, 38.52}, {8, 54.32}}},
          {"5.7", boards, lm, both, 1, {{3, 0}, {5, 27.42}, {8, 45.40}}},
          {"5.8", boards, random, none, 1, {{3, 99.18}, {8, 99.98}}},
          {"5.8", boards, random, pixel, 1, {{3, 44.80}, {8, 90.02}}},
          {"5.8", boards, random, joint, 1, {{3, 49.30}, {8, 65.38}}},
          {"5.8", boards, random, both, 1, {{3, 25.94}, {8, 56.90}}},
          {"5.8", boards, random, joint, 3, {{3, 77.16}, {8, 89.38}}},
          {"5.8", boards, random, both, 3, {{3, 34.38}, {8, 76.28}}}};
}

/// The same as the thesis's own program made them, and its author's later runs of table 5.7 with eight boards (the
/// program's doc/logs/2019-06-02/summary.json, "stdLm").
std::vector<PublishedRow> programRows() {
  using enum ThesisNoise;
  constexpr auto lm = ThesisSolver::program;
  constexpr auto eight = ThesisFeature::eightBoards;
  std::vector<PublishedRow> rows = publishedRows();
  for (PublishedRow& row : rows) {
    row.feature = row.table == "5.6"   ? ThesisFeature::programGrid
                  : row.table == "5.7" ? ThesisFeature::fourBoards
                                       : ThesisFeature::eightBoards;
    row.solver = row.table == "5.8" ? ThesisSolver::programStarts : ThesisSolver::program;
    row.table += "-program";
  }
  rows.push_back({"5.7-log", eight, lm, none, 1, {{3, 57.88}, {5, 67.28}, {8, 84.18}}});
  rows.push_back({"5.7-log", eight, lm, pixel, 1, {{3, 34.14}, {5, 47.02}, {8, 74.76}}});
  rows.push_back({"5.7-log", eight, lm, joint, 1, {{3, 34.92}, {5, 38.02}, {8, 54.54}}});
  rows.push_back({"5.7-log", eight, lm, both, 1, {{3, 20.70}, {5, 31.10}, {8, 48.70}}});
  rows.push_back({"5.7-log", eight, lm, joint, 3, {{3, 47.86}, {5, 54.18}, {8, 74.82}}});
  rows.push_back({"5.7-log", eight, lm, both, 3, {{3, 27.24}, {5, 39.70}, {8, 64.32}}});
  rows.push_back({"5.6-log", ThesisFeature::programGrid, lm, joint, 3, {{3, 69.30}, {5, 73.80}, {8, 76.32}}});
  rows.push_back({"5.6-log", ThesisFeature::programGrid, lm, both, 3, {{3, 67.54}, {5, 72.06}, {8, 75.30}}});
  return rows;
}

/// Interpretations to evaluate: one without joint noise, otherwise three.
std::vector<AngleNoise> readings(const ThesisSetting& setting) {
  return setting.angleNoise() ? std::vector{AngleNoise::radians, AngleNoise::degrees, AngleNoise::encoder}
                              : std::vector{AngleNoise::radians};
}

} // namespace

std::string ThesisSetting::name() const {
  return fmt::format("{}, {} poses, {}{}{}{}{}{}{}", toString(feature), poses, toString(noise),
                     angleNoise() ? fmt::format(" ({})", toString(jointNoise)) : "",
                     samples > 1 ? fmt::format(", {} samples", samples) : "", largeErrors ? ", 1..6.5 deg" : "",
                     bothLegs ? ", both legs" : "", unknownPlaces ? ", mounts and places unknown" : "",
                     choice == PoseChoice::chain     ? ", the thesis's poses"
                     : choice == PoseChoice::program ? ", its program's poses"
                     : choice == PoseChoice::file    ? ", poses of a file"
                                                     : "");
}

std::vector<ThesisCell> thesisCells() {
  constexpr auto lm = ThesisSolver::plain, random = ThesisSolver::randomStarts;
  const ThesisSetting all{.feature = ThesisFeature::grid}, large{.feature = ThesisFeature::grid, .largeErrors = true};
  std::vector<ThesisCell> cells{
      {"5.5", all, lm, 0.87}, {"5.5", all, random, 0.981}, {"5.5", large, lm, 0.46}, {"5.5", large, random, 0.968}};
  for (const PublishedRow& row : publishedRows()) {
    for (const auto& [poses, percent] : row.success) {
      ThesisSetting setting{.feature = row.feature, .poses = poses, .noise = row.noise, .samples = row.samples};
      for (const AngleNoise reading : readings(setting)) {
        setting.jointNoise = reading;
        cells.push_back({row.table, setting, row.solver, std::round(100 * percent) / 1e4});
      }
    }
  }
  for (const std::vector<ThesisCell>& more : {programCells(), furtherCells()}) {
    cells.insert(cells.end(), more.begin(), more.end());
  }
  return cells;
}

std::vector<ThesisCell> programCells() {
  std::vector<ThesisCell> cells;
  for (const PublishedRow& row : programRows()) {
    for (const auto& [poses, percent] : row.success) {
      const ThesisSetting setting{.feature = row.feature,
                                  .poses = poses + 1,
                                  .noise = row.noise,
                                  .jointNoise = AngleNoise::unrounded,
                                  .samples = row.samples,
                                  .choice = PoseChoice::program,
                                  .errorSets = ErrorSets::program};
      cells.push_back({row.table, setting, row.solver, std::round(100 * percent) / 1e4});
    }
  }
  return cells;
}

std::vector<ThesisSetting> fileSettings(const ThesisSetting& common) {
  std::vector<ThesisSetting> settings(4, common);
  for (std::size_t noise = 0; noise < settings.size(); ++noise) {
    settings[noise].noise = static_cast<ThesisNoise>(noise);
  }
  return settings;
}

std::vector<ThesisCell> furtherCells() {
  const ThesisSetting real{.noise = ThesisNoise::both, .jointNoise = AngleNoise::encoder};
  ThesisSetting legs = real, places = real, sticking = real, chain = real;
  legs.bothLegs = true;
  places.unknownPlaces = true;
  sticking.jointNoise = AngleNoise::stiction;
  chain.choice = PoseChoice::chain;
  std::vector<ThesisCell> cells;
  for (ThesisSetting setting : {real, chain, sticking, legs, places}) {
    for (const std::size_t poses : {3, 5, 8}) {
      setting.poses = poses;
      cells.push_back({"beyond", setting, ThesisSolver::plain, std::nullopt});
    }
  }
  return cells;
}

bool isInTable55(const ThesisSetting& setting) {
  return setting.feature == ThesisFeature::grid && setting.poses == 3 && setting.noise == ThesisNoise::none;
}

SolvedSettings thesisSettings() {
  std::map<ThesisSetting, std::set<ThesisSolver>> settings;
  for (const ThesisCell& cell : thesisCells()) {
    settings[cell.setting].insert({cell.solver, ThesisSolver::plain, ThesisSolver::ours});
  }
  SolvedSettings result;
  for (const auto& [setting, solvers] : settings) {
    result.emplace_back(setting, std::vector<ThesisSolver>(solvers.begin(), solvers.end()));
  }
  return result;
}

std::string_view toString(ThesisFeature feature) {
  return std::array{"grid", "boards", "program-grid", "program-boards-4", "program-boards-8", "file"}.at(
      static_cast<std::size_t>(feature));
}

std::string_view toString(ThesisNoise noise) {
  return std::array{"none", "pixel", "joint", "both"}.at(static_cast<std::size_t>(noise));
}

std::string_view toString(AngleNoise noise) {
  return std::array{"0.007rad", "0.007deg", "encoder", "encoder+stiction", "0.007deg-unrounded"}.at(
      static_cast<std::size_t>(noise));
}

std::string_view toString(PoseChoice choice) {
  return std::array{"ours", "thesis-chain", "thesis-program", "file"}.at(static_cast<std::size_t>(choice));
}

std::string_view toString(ErrorSets errors) {
  return std::array{"uniform", "thesis-program", "file"}.at(static_cast<std::size_t>(errors));
}

std::string_view toString(ThesisSolver solver) {
  return std::array{"lm", "lm-random-starts", "ours", "lm-numeric", "dlib", "pso", "lm-program", "lm-program-starts"}
      .at(static_cast<std::size_t>(solver));
}

} // namespace naocal
