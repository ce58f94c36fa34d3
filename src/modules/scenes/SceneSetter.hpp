#pragma once

#include "math/Sampling.hpp"
#include "scenes/RobotScene.hpp"
#include "scenes/SceneSimulation.hpp"

#include <optional>
#include <string>

namespace naocal {

/// Draws where things truly stand: exactly where the scene places them, else about there.
class SceneSetter {
public:
  SceneSetter(const RobotScene& scene, const ScenePlan& plan);

  /// The scene's set with everything placed, in the simulator's world.
  CaptureSet set();

private:
  Placement draw(const std::string& name, const std::optional<Placement>& given, const std::optional<Placement>& guess,
                 bool isFlat);
  Placement spread(Placement placement, bool isFlat);
  Eigen::Vector3d drawPoint(const std::string& name, const Eigen::Vector3d& guess);

  const RobotScene& scene_;
  double spread_;
  RandomStream chance_;
};

} // namespace naocal
