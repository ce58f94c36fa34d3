#pragma once

#include "estimation/ModelBuilder.hpp"
#include "scenes/ScenePoses.hpp"
#include "scenes/SceneSimulation.hpp"

#include <string>
#include <vector>

namespace naocal {

inline constexpr std::size_t mostTries = 4000; // poses drawn per pose wanted

/// What must be seen in a pose that is kept: "a camera sees eight corners of a board".
std::string sufficientSight(const RobotScene& scene);

/// A robot with true unknowns among things that truly stand somewhere; predicts what is read in a pose.
class TrueRobot {
public:
  /// Keeps references to both. Throws InputError for flaws that this robot in this scene cannot have.
  TrueRobot(const RobotScene& scene, const ScenePlan& plan);
  TrueRobot(RobotScene&&, const ScenePlan&) = delete;
  TrueRobot(const RobotScene&, ScenePlan&&) = delete;

  /// Replaces the true unknowns by those of a fit; what it does not hold is zero. `effects`: definitions of its terms.
  /// Throws InputError for terms that cannot act in this scene.
  void adoptFit(const Model& fitted, const Eigen::VectorXd& unknowns, const std::vector<Effect>& effects);

  /// A pose as it is read.
  struct Pose {
    Eigen::VectorXd recorded; // encoder angles without noise, one per joint [rad]
    Eigen::VectorXd approach; // -1, 0, +1
    Seconds time{0};
    Eigen::VectorXd deflection; // behind the encoders [rad]
  };

  /// What is read in a pose.
  struct Sight {
    std::vector<Capture> captures;     // with true readings; no joints
    std::vector<RenderedScene> scenes; // with `ScenePlan::images`: before the camera of each
    bool isEnough = false;             // eight corners of a board, or without cameras a marker or frame
  };
  Sight look(const Pose& pose);

  /// Every marker can touch every place: captures with one contact each, without joints.
  const std::vector<Capture>& touches() const { return touches_; }

  /// How far the marker of a touch is from its place, in the world [m].
  Eigen::Vector3d missAt(std::size_t touch, const Pose& pose);

  /// The link that carries the marker of a touch.
  std::size_t linkOfTouch(std::size_t touch) const;

  /// What the encoders would read where the true joints are so, but for effects other than offsets [rad].
  Eigen::VectorXd recordedAt(const Eigen::VectorXd& angles) const;

  /// The true lens of each camera.
  std::map<std::string, CameraIntrinsics> lenses() const;

  /// The true unknowns, and flaws of the set-up.
  std::vector<TrueEffect> listEffects() const;

  /// The scene's set with everything placed where it truly is.
  const CaptureSet& set() const { return set_; }
  const Robot& robot() const { return robot_; }
  ScenePoses& poses() { return poses_; }
  bool isOnSole() const;

private:
  void measureProbes();
  ModelState stateAt(ImageObservation& picture, const Pose& pose) const;
  std::string nameOfRobot() const;
  void requireSetUp(const std::string& flaw) const;
  double largestLoad(std::size_t joint, std::size_t about) const;
  double plausibleSize(const Term& term, std::size_t unknown) const;
  void drawUnknowns();
  void drawFlaws();
  std::vector<BoardCorners> seeCorners(const ImageObservation& picture, const ModelState& state,
                                       const LinkPoses& torsoFromLink) const;
  bool isInSight(const Eigen::Vector3d& trackerInTorso, const Eigen::Vector3d& pointInTorso,
                 const LinkPoses& torsoFromLink) const;
  void track(const ImageObservation& picture, const ModelState& state, const LinkPoses& torsoFromLink,
             Capture& capture) const;

  const ScenePlan& plan_;
  CaptureSet set_;
  Robot robot_;
  ScenePoses poses_;
  std::vector<Capture> readings_;      // all that could be read in a pose, as zeros
  std::vector<Capture> touches_;       // all touches that could be made
  Measurements measurements_;          // of a few poses
  std::vector<std::size_t> templates_; // pictures that predict the readings, then the touches, in their order
  Model model_;
  Eigen::VectorXd unknowns_;
};

} // namespace naocal
