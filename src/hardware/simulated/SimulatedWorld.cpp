#include "hardware/simulated/SimulatedWorld.hpp"

#include "hardware/simulated/SimulatedSides.hpp"

namespace naocal {

SimulatedWorld::SimulatedWorld(const Robot& drawing, const SimulatedPlan& plan)
    : shared_{std::make_shared<SimulatedShared>(drawing, plan)} {}

SimulatedWorld::~SimulatedWorld() = default;

std::unique_ptr<RobotInterface> SimulatedWorld::robot() {
  return simulatedRobot(shared_);
}

std::unique_ptr<CameraInterface> SimulatedWorld::cameras() {
  return simulatedCameras(shared_);
}

const SimulatedErrors& SimulatedWorld::errors() const {
  return shared_->errors;
}

SimulatedWorld::Truth SimulatedWorld::truth() const {
  const std::lock_guard lock{shared_->mutex};
  const SimulatedBody& body = shared_->body;
  return {shared_->now, body.joints(), body.worldFromTorso(), body.supportFoot(), body.fallen()};
}

std::optional<Eigen::VectorXd> SimulatedWorld::jointsAt(TimePoint time) const {
  const std::lock_guard lock{shared_->mutex};
  const auto moment = shared_->momentAt(time);
  return moment ? std::optional{moment->joints} : std::nullopt;
}

void SimulatedWorld::touch(const Touch& touch) {
  const std::lock_guard lock{shared_->mutex};
  shared_->touched = touch;
}

void SimulatedWorld::block(CameraName camera, bool blocked) {
  const std::lock_guard lock{shared_->mutex};
  shared_->cameras[std::size_t(camera)].blocked = blocked;
}

} // namespace naocal
