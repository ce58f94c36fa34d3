#include "brain/BrainModules.hpp"

#include "brain/BehaviorModule.hpp"
#include "brain/CameraMatrices.hpp"
#include "brain/CaptureCollector.hpp"
#include "brain/ImageReader.hpp"
#include "brain/Projection.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

void addBrainModules(Thread& brain, CameraInterface& cameras, const CalibrationContext& context) {
  brain.add<ImageReader>(cameras);
  brain.add<Projection>();
  brain.add<CaptureCollector>();
  brain.add<CameraMatrices>(context.drawing);
  brain.add<BehaviorModule>();
  brain.add<CalibrationRunner>(context);
}

} // namespace naocal
