#pragma once

#include "hardware/CameraFrame.hpp"
#include "hardware/simulated/SimulatedPlan.hpp"

#include <Eigen/Geometry>
#include <mutex>

namespace naocal {

/// What one camera of a simulated robot has in common for all its pictures.
struct SimulatedLens {
  Renderer renderer;
  Appearance appearance;
  std::vector<Board> boards;
  double exposureShare; // of the time from the first row's beginning to the last row's end
};

/// A picture that is rendered when somebody looks at it.
class SimulatedPicture : public PictureBytes {
public:
  /// `worldFromCamera`: at instants evenly spread over the exposure of all rows.
  SimulatedPicture(std::shared_ptr<const SimulatedLens> lens, std::vector<Eigen::Isometry3d> worldFromCamera,
                   std::uint64_t seed);

  std::span<const std::uint8_t> bytes() const override; // YUYV

private:
  RenderedScene scene(const Eigen::Isometry3d& worldFromCamera) const;
  void render() const;

  std::shared_ptr<const SimulatedLens> lens_;
  std::vector<Eigen::Isometry3d> worldFromCamera_;
  std::uint64_t seed_;
  mutable std::once_flag rendered_;
  mutable std::vector<std::uint8_t> bytes_;
};

} // namespace naocal
