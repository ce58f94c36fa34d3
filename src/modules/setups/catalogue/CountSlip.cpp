#include "math/Angles.hpp"
#include "setups/Catalogue.hpp"
#include "setups/ReadingChanges.hpp"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>

namespace naocal {

/// The count of motor turns slipped, so that the zero is off by whole turns, where the set says how far one turns the
/// joint (`slipSteps`).
SetUp countSlip() {
  return {.name = setUpName::countSlip,
          .description = "the joint's zero is off by whole turns of its motor",
          .question = "Was the motor of {} turned, or its battery empty, while it was switched off?",
          .needs = "the motor's turn at the joint (slipSteps)",
          .listPlaces =
              [](const Measurements& measurements) {
                std::vector<std::string> names = namesOfJoints(measurements);
                const std::map<std::string, double>& steps = measurements.sets->front().slipSteps;
                std::erase_if(names, [&](const std::string& name) {
                  const auto step = steps.find(name);
                  return step == steps.end() || !(step->second > 0);
                });
                return names;
              },
          .listMendings =
              [](const Measurements& measurements, const std::string& joint) {
                constexpr int most = 3; // turns
                const double step = measurements.sets->front().slipSteps.at(joint);
                std::vector<Mending> ways;
                for (int turns = -most; turns <= most; ++turns) {
                  if (turns != 0) {
                    ways.push_back(
                        {fmt::format("{}'s zero is off by about {} turn{} of its motor ({:.1f}° each): the count "
                                     "slipped",
                                     joint, turns, std::abs(turns) == 1 ? "" : "s", degrees(step)),
                         [joint, shift = -step * turns](Recording& recording) {
                           shiftJoint(recording.sets, joint, shift);
                         }});
                  }
                }
                return ways;
              }};
}

} // namespace naocal
