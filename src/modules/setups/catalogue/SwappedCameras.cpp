#include "setups/Catalogue.hpp"
#include "setups/ReadingChanges.hpp"

#include <fmt/format.h>
#include <set>

namespace naocal {

/// Pictures of one camera were filed under another's name.
SetUp swappedCameras() {
  return {.name = "swappedCameras",
          .description = "pictures of one camera are filed under the name of another, and the other way round",
          .question = "Are the pictures of {} filed under the right names?",
          .listPlaces =
              [](const Measurements& measurements) {
                std::set<std::string> cameras;
                for (const ImageObservation& picture : measurements.pictures) {
                  if (picture.camera != ImageObservation::noCamera) {
                    cameras.insert(measurements.robot.cameras[picture.camera].name);
                  }
                }
                return listPairs({cameras.begin(), cameras.end()});
              },
          .listMendings =
              [](const Measurements&, const std::string& pair) {
                const auto [one, other] = splitPair(pair);
                return std::vector<Mending>{{fmt::format("the names of the cameras {} and {} are swapped", one, other),
                                             [one = one, other = other](Recording& recording) {
                                               for (CaptureSet& set : recording.sets) {
                                                 for (Capture& capture : set.captures) {
                                                   capture.camera = capture.camera == one     ? other
                                                                    : capture.camera == other ? one
                                                                                              : capture.camera;
                                                 }
                                               }
                                             }}};
              }};
}

} // namespace naocal
