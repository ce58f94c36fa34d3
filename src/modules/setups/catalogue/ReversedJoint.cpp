#include "setups/Catalogue.hpp"
#include "setups/ReadingChanges.hpp"

#include <fmt/format.h>

namespace naocal {

/// The drawing's joint turns the other way: an axis or a motor mounted the other way round. The contract's
/// q_true = -(q_measured - o).
SetUp reversedJoint() {
  return {.name = setUpName::reversedJoint,
          .description = "the joint turns the other way than the drawing says",
          .question = "Does {} turn to the positive side of its axis in the drawing when its angle grows?",
          .listPlaces = namesOfJoints,
          .listMendings = [](const Measurements&, const std::string& joint) {
            return std::vector<Mending>{{fmt::format("{}'s angles have the wrong sign", joint),
                                         [joint](Recording& recording) { scaleJoint(recording.sets, joint, -1); }}};
          }};
}

} // namespace naocal
