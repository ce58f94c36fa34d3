#include "console/print/PrintComparison.hpp"

#include "console/print/PrintText.hpp"

#include <fmt/core.h>
#include <utility>

namespace naocal {

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
      printText("  {:<7} {:<12} {:>7.2f} px rms {:>7.2f} px median {:>7} corners\n", title, name, distances.rmsPx,
                distances.medianPx, distances.corners);
    }
  }
}

} // namespace naocal
