#pragma once

#include "camera/ObservationChain.hpp"
#include "data/Capture.hpp"
#include "effects/Effect.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace naocal {

/// The corners of one board in one picture, with the path between camera and board.
struct BoardObservation {
  ObservationChain view;
  CornerBlocks corners;
  std::vector<int> ids;
  std::size_t repeats = 1; // pictures of the same rest and camera that show this board, itself included
};

/// A target of one of the sets. `unknown`: its placement is estimated.
struct Target {
  std::string name; // "A", or "<set>/A" when several sets are given
  Board board;
  bool onFloor = true;
  bool unknown = false;
};

/// A stance of one of the sets. `unknown`: the support foot's placement is estimated.
struct StanceInstance {
  std::string name; // "0", or "<set>/0"
  SupportFoot supportFoot = SupportFoot::none;
  bool unknown = false;
  Placement placement; // as surveyed, else zero
};

/// One picture with everything that was recorded with it, in terms of the robot's joints.
struct ImageObservation {
  std::size_t set = 0, capture = 0; // index into the sets given and into that set's captures
  std::size_t camera = 0, stance = 0;
  RobotSample instant; // q = measured angles [rad], resting angles where not recorded
  ModelState nominal;  // the drawing, the file's lens, measured angles, placements known or guessed
  std::vector<BoardObservation> sightings;
  std::optional<ObservationChain>
      otherSole; // standing on both feet, once per pose: how the right sole sees the left one's floor
};

/// Pictures that share one encoder reading.
struct EncoderSample {
  std::vector<std::size_t> pictures;
  std::vector<std::size_t> encoderError; // per joint of the robot: which of its pose's encoder errors it has
};

/// An error that readings of one joint share: those of one rest.
struct EncoderErrorGroup {
  double scale = 1;       // its size against `Noise::encoder`: below 1 where readings that differ tell more
  std::size_t stance = 0; // where the robot stood: readings there share what standing up anew changes, too
};

/// Captures that were commanded to one attitude; they share one random deflection per joint.
struct PoseGroup {
  std::string name;
  std::vector<EncoderSample> readings;
  std::vector<EncoderErrorGroup> encoderErrors; // the distinct ones
  bool repeated = false; // was left and taken again: pose-level and reading-level noise can be told apart
  bool restood = false;  // so it was, and with the robot put down anew besides: the stance's noise, too
};

/// All that was measured, sorted so that no order of captures and no number of threads changes a digit.
struct Measurements {
  std::shared_ptr<const std::vector<CaptureSet>> sets; // as recorded
  Robot robot;
  StateLayout quantities{0, 0, 0};
  std::vector<Target> targets;
  std::vector<StanceInstance> stances;
  std::vector<ImageObservation> pictures;
  std::vector<PoseGroup> poses;
  std::vector<std::size_t> joints;         // motors of joints between some camera and some target, ascending
  std::vector<std::size_t> recordedMotors; // motors whose angles every capture tells, ascending
  std::vector<double> jitter; // per joint of the robot: of its encoder's readings at rest [rad]; 0: they never differ
  std::size_t cornerCount = 0;
  bool hasRepeats = false; // some pose was taken more than once
  bool samePlace = false;  // boards and stances of equal ids are the same in all sets

  /// The set that a picture belongs to, and its capture as recorded.
  const CaptureSet& setOf(const ImageObservation& picture) const { return (*sets)[picture.set]; }
  const Capture& captureOf(const ImageObservation& picture) const { return setOf(picture).captures[picture.capture]; }
};

/// Of each picture the pose that it belongs to; 0 for one without corners, which belongs to none.
std::vector<std::size_t> posesOfPictures(const Measurements& measurements);

/// Prepares sets of one robot. `samePlace` joins boards and stances of equal ids over the sets.
/// Throws InputError for what the robot cannot have measured (unknown link, joint needed but not recorded, other
/// robot).
Measurements buildMeasurements(std::vector<CaptureSet> sets, const Robot& robot, bool samePlace = false);

/// Joints between the picture's camera and what it shows, and between the soles where both stand, ascending.
std::vector<std::size_t> observedJoints(const Robot& robot, const ImageObservation& picture);

} // namespace naocal
