#include "hardware/simulated/SimulatedCamera.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal {

namespace {

using std::chrono::nanoseconds;

nanoseconds whole(Seconds seconds) {
  return std::chrono::duration_cast<nanoseconds>(seconds);
}

} // namespace

SimulatedCamera::SimulatedCamera(CameraName name, const SimulatedPlan& plan, TimePoint first)
    : name_{name}, plan_{plan.cameras}, seed_{plan.seed * 2 + (name == CameraName::bottom)},
      chance_{plan.seed, fmt::format("camera {}", toString(name))}, first_{first} {
  const double share = plan_.exposure / (plan_.exposure + plan_.readOut);
  lens_ = std::make_shared<const SimulatedLens>(SimulatedLens{
      Renderer{plan_.intrinsics.at(std::string{toString(name)}), seed_}, plan_.appearance, plan.boards, share});
  schedule();
}

nanoseconds SimulatedCamera::span() const {
  return whole(plan_.exposure + plan_.readOut);
}

void SimulatedCamera::schedule() {
  const Seconds late{
      std::clamp(chance_.normal(plan_.jitter.count()), -plan_.period.count() / 4, plan_.period.count() / 4)};
  begins_ = first_ + whole(double(sequence_) * plan_.period + late);
}

std::optional<TimePoint> SimulatedCamera::arrivedBy(TimePoint now) {
  return begins_ + span() + whole(plan_.transfer) <= now ? std::optional{begins_} : std::nullopt;
}

void SimulatedCamera::deliver(const std::vector<Eigen::Isometry3d>& worldFromCamera) {
  const bool lost = chance_.chance(plan_.lostShare);
  link.lost += lost || blocked;
  if (!lost && !blocked) {
    link.skipped += pending.has_value();
    const CameraIntrinsics& size = lens_->renderer.intrinsics();
    pending = {name_,
               PixelFormat::yuyv,
               size.width,
               size.height,
               begins_,
               sequence_,
               std::make_shared<SimulatedPicture>(lens_, worldFromCamera, (seed_ << 32U) ^ sequence_)};
  }
  ++sequence_;
  schedule();
}

} // namespace naocal
