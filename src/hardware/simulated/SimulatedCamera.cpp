#include "hardware/simulated/SimulatedCamera.hpp"

#include "math/RigidTransform.hpp"

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
  lens_ = std::make_shared<const SimulatedOptics>(SimulatedOptics{
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

std::optional<TimePoint> SimulatedCamera::nextArrival(TimePoint now) {
  return begins_ + span() + whole(plan_.transfer) <= now ? std::optional{begins_} : std::nullopt;
}

void SimulatedCamera::deliver(const std::vector<Eigen::Isometry3d>& worldFromCamera) {
  const bool lost = chance_.bernoulli(plan_.lostShare);
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
               std::make_shared<SimulatedImage>(lens_, worldFromCamera, (seed_ << 32U) ^ sequence_)};
  }
  ++sequence_;
  schedule();
}

SimulatedImage::SimulatedImage(std::shared_ptr<const SimulatedOptics> lens,
                               std::vector<Eigen::Isometry3d> worldFromCamera, std::uint64_t seed)
    : lens_{std::move(lens)}, worldFromCamera_{std::move(worldFromCamera)}, seed_{seed} {}

std::span<const std::uint8_t> SimulatedImage::bytes() const {
  std::call_once(rendered_, [this] { render(); });
  return bytes_;
}

RenderedScene SimulatedImage::scene(const Eigen::Isometry3d& worldFromCamera) const {
  RenderedScene scene;
  for (const Board& board : lens_->boards) {
    const Eigen::Isometry3d opticalFromBoard =
        opticalFromCamera() * (worldFromCamera.inverse() * isometryFromPlacement(*board.placement));
    scene.boards.push_back({board.id, *board.pattern, {opticalFromBoard.linear(), opticalFromBoard.translation()}});
  }
  return scene;
}

void SimulatedImage::render() const {
  constexpr double still = 1e-5; // [m], [rad]; about 0.01 px
  const Eigen::Isometry3d moved = worldFromCamera_.front().inverse() * worldFromCamera_.back();
  const bool moves = !moved.isApprox(Eigen::Isometry3d::Identity(), still);
  std::vector<RenderedScene> scenes;
  for (const Eigen::Isometry3d& instant : worldFromCamera_) {
    scenes.push_back(scene(instant));
  }
  const GreyPicture grey = moves ? lens_->renderer.render(scenes, lens_->exposureShare, lens_->appearance, seed_)
                                 : lens_->renderer.render(scenes[scenes.size() / 2], lens_->appearance, seed_);
  bytes_.assign(2 * grey.pixels.size(), 128); // neutral chroma
  for (std::size_t pixel = 0; pixel < grey.pixels.size(); ++pixel) {
    bytes_[2 * pixel] = grey.pixels[pixel];
  }
}

} // namespace naocal
