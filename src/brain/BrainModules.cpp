#include "brain/BrainModules.hpp"

#include "brain/BehaviorModule.hpp"
#include "brain/CameraMatrices.hpp"
#include "brain/CaptureCollector.hpp"
#include "brain/ImageReader.hpp"
#include "brain/Projection.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

void addBrainModules(Thread& brain, CameraInterface& cameras, const CalibrationSurroundings& surroundings) {
  brain.add<ImageReader>(cameras);
  brain.add<Projection>();
  brain.add<CaptureCollector>();
  brain.add<CameraMatrices>(surroundings.drawing);
  brain.add<BehaviorModule>();
  brain.add<CalibrationRunner>(surroundings);
}

} // namespace naocal
