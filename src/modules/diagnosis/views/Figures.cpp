#include "diagnosis/views/Figures.hpp"

#include <algorithm>

namespace naocal {

CaptureIndex indexCaptures(const Measurements& measurements) {
  CaptureIndex result;
  for (const auto& joint : measurements.robot.joints) {
    result.joints.push_back(joint.name);
  }
  for (const Target& target : measurements.targets) {
    result.boards.push_back(target.name);
  }
  for (const ImageObservation& picture : measurements.pictures) {
    const Capture& capture = measurements.captureOf(picture);
    result.pictures.push_back({capture.id, capture.camera});
    if (capture.camera.empty()) {
      continue;
    }
    const CameraIntrinsics& lens = measurements.setOf(picture).cameras.at(capture.camera);
    result.cameras[capture.camera] = {lens.width, lens.height};
  }
  for (const PoseGroup& pose : measurements.poses) {
    CaptureIndex::Pose& taken = result.poses.emplace_back();
    for (const EncoderSample& reading : pose.readings) {
      taken.pictures.insert(taken.pictures.end(), reading.pictures.begin(), reading.pictures.end());
    }
    std::sort(taken.pictures.begin(), taken.pictures.end(),
              [&](std::size_t a, std::size_t b) { return result.pictures[a].capture < result.pictures[b].capture; });
    const ImageObservation& first = measurements.pictures[taken.pictures.front()];
    taken.set = measurements.setOf(first).name;
    taken.name = measurements.captureOf(first).pose;
  }
  return result;
}

} // namespace naocal
