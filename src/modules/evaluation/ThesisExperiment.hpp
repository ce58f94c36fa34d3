#pragma once

#include "estimation/Residuals.hpp"
#include "evaluation/ThesisSetting.hpp"
#include "math/Sampling.hpp"
#include "measurements/Measurements.hpp"
#include "measurements/Noise.hpp"
#include "poses/candidates/PlanningScene.hpp"

#include <functional>
#include <vector>

namespace naocal {

/// Where a joint stands when an angle was commanded, in the encoder's space, and what the encoder tells [rad].
struct AngleReading {
  double raw, reported;
};

/// The noise that a setting's measurements have and that our solver is told of. What is not noisy gets a little, so
/// that the problem stays regular: 0.01 px, 0.03 px where angles are noisy.
Noise thesisNoise(const ThesisSetting& setting, double pixel);

/// A joint that was commanded to an angle comes to stand within half a step of its encoder, which tells its angle with
/// the setting's noise, rounded to 12 bits (4.1). Exact where the setting has no joint noise.
AngleReading readAngle(double commanded, const ThesisSetting& setting, RandomStream& chance);

/// What lies on the floor, its placements in the left sole's frame, and when a camera sees it.
struct ThesisScene {
  std::vector<Board> targets;
  std::map<std::string, CameraIntrinsics> cameras;
  VisibilityLimits limits;
};

/// Boards: the four A2 boards of simulated sets. Grid: points every 0.25 m up to 4 m away, in tiles of one square metre
/// that are told apart by correspondence; a single point of a tile is seen as well.
ThesisScene makeThesisScene(ThesisFeature feature);

/// How a robot stands, its angles per joint [rad].
struct ThesisPose {
  SupportFoot foot = SupportFoot::left;
  Eigen::VectorXd angles;
};

/// What there is to see in the poses: all of it, in pictures by each camera, as often as the setting has samples.
Measurements observeEverything(const Robot& robot, const ThesisScene& scenery, const ThesisSetting& setting,
                               const std::vector<ThesisPose>& poses);

/// The poses of a setting: the first of those chosen (selectThesisPoses), and for both legs their mirror images.
std::vector<ThesisPose> posesForSetting(const ThesisSetting& setting, const Robot& robot,
                                        const std::vector<Eigen::VectorXd>& chosen);

/// As many stable poses as wanted, in each of which all of 40 robots drawn with offsets up to 6.5 degrees see enough
/// (24 corners), chosen one by one: each the one that, on average over such robots, tells most about the offsets beside
/// those before it (largest determinant; corners within 0.3 px, an encoder's noise marginalised). Or the thesis's chain
/// among the same poses: by what looks alike to the cameras of the drawn robot. The first three are the poses for
/// three. Throws InputError when there are not that many.
std::vector<Eigen::VectorXd> selectThesisPoses(const Robot& robot, ThesisFeature feature, PoseChoice choice,
                                               std::size_t count);

/// Floor points or boards around a robot that stands on its left foot, where everything lies being known unless the
/// setting says otherwise, poses before them, and what a robot with wrong joint zeros reports of them with both cameras
/// at 640 x 480. Its 8 offsets are those of the joints between cameras and left sole; all other joints do not matter.
/// For both legs it stands on either foot in turn, the right one 0.1 m beside the left one; then there are 13.
class ThesisExperiment {
public:
  /// Every pose is taken as often as the setting has samples, each with readings of its own.
  ThesisExperiment(const Robot& robot, const ThesisSetting& setting, const std::vector<ThesisPose>& poses);

  /// What the robot sees in the poses: all corners of all targets. To be filled by `simulate`.
  const Measurements& allObservations() const { return everything_; }
  /// Motors whose offsets are to be found, ascending.
  const std::vector<std::size_t>& joints() const { return everything_.joints; }
  std::vector<std::string> jointNames() const;

  /// What can be unknown here: the offsets first, then, where the setting has them so, mounts and places.
  const Model& model() const { return model_; }

  /// Takes the poses with a robot whose joints report an angle as `read` says and stand at the reading's `raw` angle
  /// less their offset; `truth`: of the model's unknowns; `pixel` is the corners' noise [px].
  void simulate(const Eigen::VectorXd& truth, const std::function<AngleReading(double commanded)>& read, double pixel,
                RandomStream& chance, Measurements& taken) const;

private:
  void look(const ImageObservation& all, const Eigen::VectorXd& angles, const Eigen::VectorXd& truth,
            ImageObservation& seen) const;

  ThesisScene scenery_;
  Measurements everything_;
  Model model_;
  std::vector<std::pair<std::size_t, Eigen::Index>> driven_; // joint, and which of the stage's drives it
};

/// A stage's unknowns as a model; `sigma` of every offset and mount is its prior [rad].
Model makeExperimentModel(const ThesisExperiment& stage, double offsetSigma, double mountSigma);

} // namespace naocal
