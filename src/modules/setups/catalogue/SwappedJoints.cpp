#include "setups/Catalogue.hpp"
#include "setups/ReadingChanges.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal {

/// Two columns or names of joints were exchanged.
SetUp swappedJoints() {
  return {.name = "swappedJoints",
          .description = "what one joint reads is another's angle, and the other way round",
          .question = "Are the angles of {} in the order of their names?",
          .listPlaces = [](const Measurements& measurements) { return listPairs(namesOfMovingJoints(measurements)); },
          .listMendings =
              [](const Measurements&, const std::string& pair) {
                const auto [one, other] = splitPair(pair);
                return std::vector<Mending>{{fmt::format("the angles of {} and {} are swapped", one, other),
                                             [one = one, other = other](Recording& recording) {
                                               for (CaptureSet& set : recording.sets) {
                                                 auto& names = set.jointNames;
                                                 const auto first = std::find(names.begin(), names.end(), one),
                                                            second = std::find(names.begin(), names.end(), other);
                                                 if (first != names.end() && second != names.end()) {
                                                   std::iter_swap(first, second);
                                                 }
                                               }
                                             }}};
              }};
}

} // namespace naocal
