#include "console/print/PrintComparison.hpp"

#include "console/print/PrintText.hpp"

#include <algorithm>
#include <fmt/core.h>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

namespace {

void printGroup(const char* title, const std::string& name, const ResidualSummary& distances, const char* note = "") {
  printText("  {:<7} {:<12} {:>7.2f} px rms {:>7.2f} px median {:>7} corners{}\n", title, name, distances.rmsPx,
            distances.medianPx, distances.corners, note);
}

} // namespace

void printComparison(const Comparison& comparison) {
  if (comparison.all.corners > 0) {
    printText(
        "{} corners: prediction error {:.2f} px rms (median {:.2f} px); with the robot's drawing alone {:.2f} px rms"
        "\n\n",
        comparison.all.corners, comparison.all.rmsPx, comparison.all.medianPx, comparison.nominal.rmsPx);
  }
  if (!comparison.readings.empty()) {
    printText("prediction error {}; with the robot's drawing alone {}\n\n", formatSizes(comparison.readings),
              formatSizes(comparison.nominalReadings));
  }
  for (const auto& [title, groups] :
       {std::pair{"board", &comparison.byBoard}, std::pair{"camera", &comparison.byCamera}}) {
    for (const auto& [name, distances] : *groups) {
      printGroup(title, name, distances);
    }
  }
}

void printWorstPoses(const Comparison& comparison) {
  constexpr std::size_t most = 5;
  std::vector<std::pair<std::string, ResidualSummary>> poses{comparison.byPose.begin(), comparison.byPose.end()};
  std::sort(poses.begin(), poses.end(), [](const auto& a, const auto& b) { return a.second.rmsPx > b.second.rmsPx; });
  poses.resize(std::min(poses.size(), most));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    printGroup("pose", poses[i].first, poses[i].second, i == 0 ? "  (the worst come first)" : "");
  }
}

} // namespace naocal
