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
          .listPlaces =
              [](const Measurements& measurements) {
                const std::vector<std::string> names = namesOfJoints(measurements);
                std::vector<std::string> pairs;
                for (std::size_t one = 0; one < names.size(); ++one) {
                  for (std::size_t other = one + 1; other < names.size(); ++other) {
                    pairs.push_back(names[one] + ',' + names[other]);
                  }
                }
                return pairs;
              },
          .listMendings =
              [](const Measurements&, const std::string& pair) {
                const std::string one = pair.substr(0, pair.find(',')), other = pair.substr(pair.find(',') + 1);
                return std::vector<Mending>{{fmt::format("the angles of {} and {} are swapped", one, other),
                                             [one, other](Recording& recording) {
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
