#include "setups/Catalogue.hpp"
#include "setups/ReadingChanges.hpp"

#include <fmt/format.h>

namespace naocal {

/// The scalar of a tracker's quaternions stands last where the file has it first, or the other way round: both orders
/// are common.
SetUp quaternionOrder() {
  return {.name = "quaternionOrder",
          .description = "the four numbers of the tracker's quaternions stand in another order",
          .question = "Does tracker {} list the scalar w of a quaternion first or last?",
          .listPlaces = trackersOfFrames,
          .listMendings = [](const Measurements&, const std::string& tracker) {
            const auto reorder = [&](const std::string& said, const auto& from) {
              return Mending{
                  fmt::format("the quaternions of {} are in another order than the file's: {}", tracker, said),
                  [tracker, from](Recording& recording) {
                    changeFrames(recording.sets, tracker,
                                 [&](FrameReading& reading) { reading.rotation = from(reading.rotation); });
                  }};
            };
            return std::vector<Mending>{reorder("x, y, z, w",
                                                [](const Eigen::Quaterniond& q) {
                                                  return Eigen::Quaterniond{q.z(), q.w(), q.x(), q.y()};
                                                }),
                                        reorder("w, x, y, z", [](const Eigen::Quaterniond& q) {
                                          return Eigen::Quaterniond{q.x(), q.y(), q.z(), q.w()};
                                        })};
          }};
}

} // namespace naocal
