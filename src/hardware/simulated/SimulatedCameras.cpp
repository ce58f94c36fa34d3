#include "hardware/simulated/SimulatedSides.hpp"

#include <fmt/format.h>
#include <utility>

namespace naocal {

namespace {

class SimulatedCameras : public CameraInterface {
public:
  explicit SimulatedCameras(std::shared_ptr<SimulatedShared> shared) : shared_{std::move(shared)} {
    const std::lock_guard lock{shared_->mutex};
    shared_->step.use(true);
  }
  ~SimulatedCameras() override {
    const std::lock_guard lock{shared_->mutex};
    shared_->step.use(false);
  }

  std::optional<CameraFrame> waitForFrame(std::chrono::milliseconds timeout) override {
    std::unique_lock lock{shared_->mutex};
    SimulatedCamera& top = shared_->cameras[0];
    SimulatedCamera& bottom = shared_->cameras[1];
    shared_->step.waitForPicture(lock, timeout, [this] { return shared_->picturePending(); });
    if (!top.pending && !bottom.pending) {
      return std::nullopt;
    }
    SimulatedCamera& older =
        !bottom.pending || (top.pending && top.pending->time <= bottom.pending->time) ? top : bottom;
    ++older.link.frames;
    return std::exchange(older.pending, std::nullopt);
  }

  CameraLink link(CameraName camera) const override {
    const std::lock_guard lock{shared_->mutex};
    const SimulatedCamera& one = shared_->cameras[std::size_t(camera)];
    CameraLink link = one.link;
    link.problem = one.blocked ? fmt::format("the {} camera gives no pictures", toString(camera)) : "";
    return link;
  }

private:
  std::shared_ptr<SimulatedShared> shared_;
};

} // namespace

std::unique_ptr<CameraInterface> simulatedCameras(std::shared_ptr<SimulatedShared> shared) {
  return std::make_unique<SimulatedCameras>(std::move(shared));
}

} // namespace naocal
