#pragma once

#include "evaluate/ThesisNoise.hpp"
#include "evaluate/ThesisScenery.hpp"
#include "residuals/Residuals.hpp"

#include <functional>
#include <vector>

namespace naocal {

/// Floor points or boards around a robot that stands on its left foot, where everything lies being known, poses before
/// them, and what a robot with wrong joint zeros reports of them with both cameras at 640 x 480. Its 8 offsets are
/// those of the joints between cameras and left sole; all other joints do not matter.
class ThesisStage {
public:
  /// `samples`: pictures per pose and camera, each sample with readings of its own.
  ThesisStage(const Robot& robot, ThesisFeature feature, const std::vector<Eigen::VectorXd>& poses,
              std::size_t samples);

  /// What the robot sees in the poses: all corners of all targets. To be filled by `take`.
  const Measurements& everything() const { return everything_; }
  /// Motors whose offsets are to be found, ascending.
  const std::vector<std::size_t>& joints() const { return everything_.joints; }
  std::vector<std::string> jointNames() const;

  /// Takes the poses with a robot whose joints report an angle as `read` says and stand at the reading's `raw` angle
  /// less their offset; `pixel` is the corners' noise [px].
  void take(const Eigen::VectorXd& offsets, const std::function<AngleReading(double commanded)>& read, double pixel,
            Randomness& chance, Measurements& taken) const;

private:
  void look(const Picture& all, const Eigen::VectorXd& angles, Picture& seen) const;

  ThesisScenery scenery_;
  Measurements everything_;
};

/// The offsets of a stage's joints as a model; `sigma` of each is its prior [rad].
Model offsetModel(const ThesisStage& stage, double sigma);

} // namespace naocal
