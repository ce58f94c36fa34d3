#pragma once

#include "camera/ObservationChain.hpp"
#include "data/Capture.hpp"
#include "effects/Effect.hpp"
#include "measurements/FailedReadings.hpp"
#include "measurements/Instruments.hpp"
#include "measurements/Noise.hpp"
#include "measurements/Witness.hpp"

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Corners of one board in one picture, with the kinematic chain between camera and board.
struct BoardObservation {
  ObservationChain view;
  CornerBlocks corners;
  std::vector<int> ids;
  std::size_t repeats = 1; // pictures of this board by the same camera during the same rest, itself included
};

/// A target of one of the sets. `unknown`: its placement is estimated.
struct Target {
  std::string name; // "A", or "<set>/A" with several sets
  Board board;
  bool inWorld = true; // fixed in the world, not to a link
  bool isFlat = true;  // lies on the floor
  bool unknown = false;
  RigidTransform reference; // linkFromBoard or worldFromBoard = reference * T(its placement in the state)
};

/// A stance of one of the sets. `unknown`: the placement of its support is estimated.
struct StanceInstance {
  std::string name; // "0", or "<set>/0"
  SupportFoot supportFoot = SupportFoot::none;
  std::optional<std::size_t> supportLink; // link that stands in the world: a sole, or the base; absent: it hangs
  std::vector<std::size_t> furtherSoles;  // other soles that rest on the floor, too
  bool isFlat = true;                     // the support rests on the floor; else it stands anyhow (6-D)
  bool unknown = false;
  Placement placement; // as surveyed, otherwise zero
};

/// One picture, or other readings of one instant, with all data recorded for it, indexed by the robot's joints.
struct ImageObservation {
  static constexpr std::size_t noCamera = std::numeric_limits<std::size_t>::max();

  std::size_t set = 0, capture = 0;   // indices of the set and of the capture within it
  std::size_t camera = 0, stance = 0; // `noCamera`: no picture
  RobotSample instant;                // q = measured angles [rad], rest angles where not recorded
  ModelState nominal;                 // nominal geometry, the file's lens, measured angles, known or guessed placements
  std::vector<BoardObservation> observations;
  std::vector<WitnessObservation> witnesses; // measurements other than corners
  std::vector<ObservationChain> otherSoles;  // on the floor, too, once per pose: chains to the floor of the sole that
                                             // stands in the world; on a NAO's both feet, from right to left

  bool measuresNothing() const { return observations.empty() && witnesses.empty(); }
};

/// Pictures with the same encoder reading.
struct EncoderSample {
  std::vector<std::size_t> pictures;
  std::vector<std::size_t> encoderError; // per joint of the robot: index into the pose's `encoderErrors`
};

/// An encoder error shared by readings of one joint at rest.
struct EncoderErrorGroup {
  double scale = 1;       // relative to `Noise::encoder`: below 1 if differing readings improve the estimate
  std::size_t stance = 0; // stance, for the noise shared by all readings of a stance
};

/// Captures commanded to the same pose; they share one random deflection per joint.
struct PoseGroup {
  std::string name;
  std::vector<EncoderSample> readings;
  std::vector<EncoderErrorGroup> encoderErrors; // distinct errors
  bool repeated = false;                        // left and re-approached: separates pose noise from re-approach noise
  bool restood = false; // the same, and with the robot put down anew in between: separates stance noise, too
};

/// All measurements, in an order independent of the order of captures and the number of threads, so that results are
/// bitwise reproducible.
struct Measurements {
  std::shared_ptr<const std::vector<CaptureSet>> sets; // as recorded, without `failedReadings`
  Robot robot;
  StateLayout quantities{0, 0, 0};
  std::vector<Target> targets;
  std::vector<StanceInstance> stances;
  InstrumentList instruments;
  std::vector<ReadingLevel> levels; // noise levels of witnesses
  std::vector<ImageObservation> pictures;
  std::vector<PoseGroup> poses;
  std::vector<std::size_t> joints;         // motors of joints between a camera and a target, ascending
  std::vector<std::size_t> recordedMotors; // motors whose angle is recorded in every capture, ascending
  std::vector<double> jitter; // per joint of the robot: encoder jitter at rest [rad]; 0: readings never differ
  std::size_t cornerCount = 0, witnessCount = 0;
  bool hasRepeats = false;             // a pose was captured more than once
  std::size_t approachesFromOrder = 0; // pictures with directions of approach that the order of captures tells
  std::vector<std::vector<FailedReadings>> failedReadings; // of trackers, per set: left out
  bool samePlace = false;                                  // boards and stances of equal id are the same in all sets

  /// Whether a camera stands beside the robot at an unknown place.
  bool isCameraUnknown(std::size_t camera) const;

  /// Whether a joint of a robot with a URDF has an encoder whose step its set does not tell. Its noise is part of the
  /// scatter from pose to pose, which must then be estimated.
  bool hasUnknownSteps() const;

  /// Whether readings other than corners have a noise level that the sets do not give: it is estimated.
  bool hasUnknownNoise() const;

  /// The set and the capture that a picture was made from.
  const CaptureSet& setOf(const ImageObservation& picture) const { return (*sets)[picture.set]; }
  const Capture& captureOf(const ImageObservation& picture) const { return setOf(picture).captures[picture.capture]; }
};

/// 1 sigma of a noise level of readings [m] or [rad].
double sigmaOf(const Measurements& measurements, const Noise& noise, std::size_t level);

/// Pose index of each picture; 0 for a picture without corners, which belongs to no pose.
std::vector<std::size_t> posesOfPictures(const Measurements& measurements);

/// Builds the measurements from sets of one robot. `samePlace` merges boards and stances of equal id across sets.
/// Leaves out readings of trackers that are none, and takes directions of approach from the order of captures where
/// none were recorded. Throws InputError for captures that do not fit the robot (unknown link, required joint not
/// recorded, other robot).
Measurements buildMeasurements(std::vector<CaptureSet> sets, const Robot& robot, bool samePlace = false);

/// Joints between the picture's camera and its targets, and between the soles if both are on the floor, ascending.
std::vector<std::size_t> observedJoints(const Robot& robot, const ImageObservation& picture);

} // namespace naocal
