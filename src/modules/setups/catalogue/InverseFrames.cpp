#include "setups/Catalogue.hpp"
#include "setups/ReadingChanges.hpp"

#include <fmt/format.h>

namespace naocal {

/// A tracker's poses are those of the tracker in the frame, not of the frame in the tracker; or only the rotations are.
SetUp inverseFrames() {
  return {
      .name = "inverseFrames",
      .description = "the tracker's poses are the inverse of what is expected",
      .question = "Are the poses of {} those of the frame in the tracker, or of the tracker in the frame?",
      .listPlaces = trackersOfFrames,
      .listMendings = [](const Measurements&, const std::string& tracker) {
        return std::vector<Mending>{
            {fmt::format("the poses of {} are those of the tracker in the frame, not of the frame in the tracker",
                         tracker),
             [tracker](Recording& recording) {
               changeFrames(recording.sets, tracker, [](FrameReading& reading) {
                 reading.rotation = reading.rotation.conjugate();
                 reading.xyz = -(reading.rotation.normalized() * reading.xyz);
               });
             }},
            {fmt::format("the rotations of {} are those of the tracker in the frame, not of the frame in the tracker",
                         tracker),
             [tracker](Recording& recording) {
               changeFrames(recording.sets, tracker,
                            [](FrameReading& reading) { reading.rotation = reading.rotation.conjugate(); });
             }}};
      }};
}

} // namespace naocal
