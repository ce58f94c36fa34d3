#pragma once

#include "evaluate/ThesisNoise.hpp"
#include "evaluate/ThesisScenery.hpp"
#include "residuals/Residuals.hpp"

#include <functional>
#include <vector>

namespace naocal {

/// Floor points or boards around a robot that stands on its left foot, where everything lies being known unless the
/// setting says otherwise, poses before them, and what a robot with wrong joint zeros reports of them with both cameras
/// at 640 x 480. Its 8 offsets are those of the joints between cameras and left sole; all other joints do not matter.
/// For both legs it stands on either foot in turn, the right one 0.1 m beside the left one; then there are 13.
class ThesisStage {
public:
  /// Every pose is taken as often as the setting has samples, each with readings of its own.
  ThesisStage(const Robot& robot, const ThesisSetting& setting, const std::vector<ThesisPose>& poses);

  /// What the robot sees in the poses: all corners of all targets. To be filled by `take`.
  const Measurements& everything() const { return everything_; }
  /// Motors whose offsets are to be found, ascending.
  const std::vector<std::size_t>& joints() const { return everything_.joints; }
  std::vector<std::string> jointNames() const;

  /// What can be unknown here: the offsets first, then, where the setting has them so, mounts and places.
  const Model& model() const { return model_; }

  /// Takes the poses with a robot whose joints report an angle as `read` says and stand at the reading's `raw` angle
  /// less their offset; `truth`: of the model's unknowns; `pixel` is the corners' noise [px].
  void take(const Eigen::VectorXd& truth, const std::function<AngleReading(double commanded)>& read, double pixel,
            Randomness& chance, Measurements& taken) const;

private:
  void look(const Picture& all, const Eigen::VectorXd& angles, const Eigen::VectorXd& truth, Picture& seen) const;

  ThesisScenery scenery_;
  Measurements everything_;
  Model model_;
  std::vector<std::pair<std::size_t, Eigen::Index>> driven_; // joint, and which of the stage's drives it
};

/// A stage's unknowns as a model; `sigma` of every offset and mount is its prior [rad].
Model unknownsOf(const ThesisStage& stage, double offsetSigma, double mountSigma);

} // namespace naocal
