#pragma once

#include "estimation/Residuals.hpp"
#include "evaluation/thesis/NoiseOfSetting.hpp"
#include "evaluation/thesis/SoleCamera.hpp"
#include "evaluation/thesis/ThesisScene.hpp"
#include "math/Sampling.hpp"
#include "measurements/Measurements.hpp"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace naocal {

/// What a run reads from files, or selects once for all settings.
struct ThesisInputs {
  std::vector<FloorPattern> features;   // of ThesisFeature::file
  std::vector<Eigen::VectorXd> offsets; // of ErrorSets::file, per joint of the experiment [rad]
  std::vector<Eigen::VectorXd> heldOut; // poses to test calibrations, angles per joint of the experiment [rad]
};

/// A pose: support foot and angles per joint [rad].
struct ThesisPose {
  SupportFoot foot = SupportFoot::left;
  Eigen::VectorXd angles;
};

/// The thesis's experiment: floor points or boards around a robot on its left foot, at known places unless the setting
/// says otherwise; a robot with joint offsets observes them in several poses with both cameras at 640 x 480. The 8
/// unknown offsets are those of the joints between cameras and left sole; all others have no influence. For both legs
/// the robot also stands on the right foot, 0.1 m beside the left one, with 13 offsets.
class ThesisExperiment {
public:
  /// Each pose is taken as often as the setting has samples, with new readings each time.
  ThesisExperiment(const Robot& robot, const ThesisSetting& setting, const std::vector<ThesisPose>& poses,
                   const ThesisInputs& inputs = {});

  /// All corners of all targets in all poses; template for `simulate`.
  const Measurements& allObservations() const { return everything_; }
  /// Motors of the unknown offsets, ascending.
  const std::vector<std::size_t>& joints() const { return everything_.joints; }
  std::vector<std::string> jointNames() const;

  const ThesisInputs& inputs() const { return inputs_; }

  /// The bottom camera above the left sole, with the joints of the experiment as motors.
  template <typename Scalar> SoleCamera<Scalar> bottomCamera() const;

  /// All points on the floor, in the left sole's frame [m]; of settings like the program's, as the next function.
  Eigen::Matrix2Xd floorPoints() const;
  /// A target's point of an observation in the left sole's frame [m].
  Eigen::Vector2d floorPoint(const BoardObservation& observation, std::size_t corner) const;

  /// What the bottom camera sees of the floor in each pose, without offsets (fieldOfView).
  std::vector<std::array<Eigen::Vector2d, 4>> fieldsOfView() const;

  /// Possible unknowns: the offsets first, followed by mounts and places if the setting has them.
  const Model& model() const { return model_; }

  /// Simulates captures of all poses: `read` maps commanded angles to readings, true angle = reading's `raw` - offset;
  /// `truth`: values of the model's unknowns; `pixel`: corner noise, 1 sigma [px], anew in every picture; with settings
  /// like the program's the same in all pictures of a pose.
  void simulate(const Eigen::VectorXd& truth, const std::function<AngleReading(double commanded)>& read, double pixel,
                RandomStream& chance, Measurements& taken) const;

private:
  void look(const ImageObservation& all, const Eigen::VectorXd& angles, const Eigen::VectorXd& truth,
            ImageObservation& seen) const;

  void addCornerNoise(double pixel, RandomStream& chance, Measurements& taken) const;

  void lookAsProgram(const ImageObservation& all, const Eigen::VectorXd& angles, ImageObservation& seen) const;

  ThesisInputs inputs_;
  ThesisScene scenery_;
  Measurements everything_;
  std::optional<SoleCamera<double>> tested_;   // camera of the horizon test
  std::vector<Eigen::Matrix2Xd> targetPoints_; // per target, if there is a horizon test [m]
  Model model_;
  std::vector<std::pair<std::size_t, Eigen::Index>> driven_; // joint, and the index of its motor in `joints()`
};

/// The experiment's unknowns as a model, with the given prior sigmas of offsets and mounts [rad].
Model makeExperimentModel(const ThesisExperiment& stage, double offsetSigma, double mountSigma);

} // namespace naocal
