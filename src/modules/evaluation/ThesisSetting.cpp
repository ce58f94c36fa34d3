#include "evaluation/ThesisSetting.hpp"

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
                     choice == PoseChoice::chain ? ", the thesis's poses" : "");
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
  const std::vector<ThesisCell> beyond = furtherCells();
  cells.insert(cells.end(), beyond.begin(), beyond.end());
  return cells;
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

std::vector<std::pair<ThesisSetting, std::vector<ThesisSolver>>> thesisSettings() {
  std::map<ThesisSetting, std::set<ThesisSolver>> settings;
  for (const ThesisCell& cell : thesisCells()) {
    settings[cell.setting].insert({cell.solver, ThesisSolver::plain, ThesisSolver::ours});
  }
  std::vector<std::pair<ThesisSetting, std::vector<ThesisSolver>>> result;
  for (const auto& [setting, solvers] : settings) {
    result.emplace_back(setting, std::vector<ThesisSolver>(solvers.begin(), solvers.end()));
  }
  return result;
}

std::string_view toString(ThesisFeature feature) {
  return feature == ThesisFeature::grid ? "grid" : "boards";
}

std::string_view toString(ThesisNoise noise) {
  return std::array{"none", "pixel", "joint", "both"}.at(static_cast<std::size_t>(noise));
}

std::string_view toString(AngleNoise noise) {
  return std::array{"0.007rad", "0.007deg", "encoder", "encoder+stiction"}.at(static_cast<std::size_t>(noise));
}

std::string_view toString(PoseChoice choice) {
  return choice == PoseChoice::ours ? "ours" : "thesis-chain";
}

std::string_view toString(ThesisSolver solver) {
  return std::array{"lm", "lm-random-starts", "ours", "lm-numeric", "dlib", "pso"}.at(static_cast<std::size_t>(solver));
}

} // namespace naocal
