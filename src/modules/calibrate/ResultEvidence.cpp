#include "calibrate/ResultEvidence.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

using nlohmann::json;

namespace {

json pointsJson(const Eigen::Matrix2Xd& points) {
  json list = json::array();
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    list.push_back({points(0, i), points(1, i)});
  }
  return list;
}

} // namespace

json doubtfulJson(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                  const CalibrationResult& result) {
  json list = json::array();
  for (const Doubt& doubt : result.doubts) {
    const Picture& picture = measurements.pictures[doubt.picture];
    const CaptureSet& set = sets[picture.set];
    list.push_back({{"set", set.name},
                    {"capture", set.captures[picture.capture].id},
                    {"board", measurements.targets[picture.sightings[doubt.sighting].view.board()].name},
                    {"corners", doubt.corners},
                    {"whole", doubt.whole},
                    {"distancePx", doubt.distance}});
  }
  return list;
}

json sightingsJson(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                   const CalibrationResult& result) {
  json list = json::array();
  for (std::size_t i = 0; i < result.sightings.size(); ++i) {
    const SightingResidual& seen = result.sightings[i];
    const Picture& picture = measurements.pictures[seen.picture];
    const Sighting& sighting = picture.sightings[seen.sighting];
    const Capture& capture = sets[picture.set].captures[picture.capture];
    list.push_back({{"set", sets[picture.set].name},
                    {"capture", capture.id},
                    {"pose", capture.pose},
                    {"repeat", capture.repeat},
                    {"time", capture.time.count()},
                    {"camera", capture.camera},
                    {"image", capture.image},
                    {"board", measurements.targets[sighting.view.board()].name},
                    {"ids", sighting.ids},
                    {"measured", pointsJson(seen.predicted + seen.residual)},
                    {"predicted", pointsJson(result.asReported[i].predicted)},
                    {"fitted", pointsJson(seen.predicted)},
                    {"weight", std::vector<double>(seen.weight.begin(), seen.weight.end())}});
  }
  return list;
}

json camerasJson(const std::vector<CaptureSet>& sets) {
  json cameras;
  for (const CaptureSet& set : sets) {
    for (const auto& [name, camera] : set.cameras) {
      cameras[set.name][name] = {{"width", camera.width}, {"height", camera.height}};
    }
  }
  return cameras;
}

} // namespace naocal
