#pragma once

#include "brain/BehaviorModule.hpp"
#include "brain/CalibrationInputs.hpp"
#include "brain/CalibrationJobs.hpp"
#include "brain/CalibrationStatus.hpp"
#include "brain/CaptureCollector.hpp"
#include "brain/CaptureFaults.hpp"
#include "brain/Projection.hpp"
#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"
#include "hardware/messages/PoseRequest.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Calibrates the robot: captures boards in a first round of poses, solves, applies joint offsets and camera mounts,
/// and measures the error in a second, shorter round. Saves the result if the error falls by half or more; otherwise
/// restores the previous calibration: the robot was well calibrated already, or another error dominates. Slow steps run
/// in `CalibrationJobs`.
///
/// Setting the parameter `run` to the name of a kind starts a calibration (the value from the file does not); any other
/// value aborts it. The chest button starts one too, and confirms questions. "poses" plays the parameter `poses` and
/// records captures without calibrating; "undo" undoes the last saved calibration.
class CalibrationRunner final : public Module {
public:
  explicit CalibrationRunner(CalibrationContext context);
  void cycle() override;
  void onParametersChanged() override;
  void onThreadEnd() override { jobs_.finish(); }

private:
  void start(const CalibrationKind& kind);
  void prepare();
  void startAskedPoses();
  void enter(CalibrationState::Phase phase, const std::string& sentence);
  void fail(const std::string& sentence);
  void startRound();
  void nextStep();
  void go();
  void ask(PoseRequest::Kind kind, const std::string& name, std::vector<CompensatedAngles> points, bool held = false);
  void watchPlayer();
  void chestPressed();
  void follow(const HeadLookRequest& look);
  bool isStill(const CameraFrame& frame);
  void collect();
  bool takePicture(); // if one is available and everything is still; otherwise reports the reason to wait
  void waitFor(const std::string& what);
  void tellTimeLeft();
  void arriveAtStand();
  void endStep();
  void endRound();
  void takeResults();
  void take(CalibrationJobs::PlannedRounds planned);
  void take(CalibrationJobs::AppliedCalibration applied);
  void take(CalibrationJobs::CheckedCalibration checked);
  void take(CalibrationJobs::ModelDiagnosis diagnosis);
  void take(CalibrationJobs::CalibrationUndone);
  void take(CalibrationJobs::JobFailure failure);
  void take(const Capture& capture);
  void tellError(const CalibrationRecorder::ErrorComparison& error, bool isKept);
  CaptureSet header() const;

  CommandParameter<std::string> run_{*this, "run"};
  CommandParameter<int> confirmed_{*this, "confirmed"};
  CommandParameter<RequestedPoses> askedPoses_{*this, "poses"};
  Parameter<std::string> chestStarts_{*this, "chestStarts"}; // kind started by the chest button; empty: none
  Parameter<std::vector<double>> yaws_{*this, "headYaws", checkEachWithin<-119, 119>},
      pitches_{*this, "headPitches", checkEachWithin<-38, 29>};         // [deg]
  Parameter<int> repeats_{*this, "repeats", checkWithin<1, 20>};        // images per camera and pose
  Parameter<int> checkPoses_{*this, "checkPoses", checkWithin<1, 100>}; // per foot, in the check round
  Parameter<double> approach_{*this, "approach", checkWithin<0, 5>};    // distance from which joints approach a pose
                                                                        // [deg]
  Parameter<std::uint64_t> orderSeed_{*this, "seed"};                   // of the random order of poses
  Parameter<double> settleTime_{*this, "settle", checkWithin<0, 10>};   // stillness required before an image [s]
  Parameter<double> stillPicture_{*this, "stillPicture",
                                  checkWithin<0, 255>}; // largest change from the previous image [grey levels]
  Parameter<CalibrationBoards> boards_{*this, "boards"};
  Dependency<StillImage> picture_{*this, "stillPicture"};
  Dependency<CameraModels> cameras_{*this, "cameras"};
  Dependency<HeadLookRequest> look_{*this, "wantedLook"};
  Dependency<Latest<PlayerState>> playerUpdates_{*this, "Motion.playerForBrain"};
  Production<Latest<PoseRequest>> request_{*this, "poseRequest"};
  Production<CalibrationState> state_{*this, "calibration"};
  Production<std::vector<CalibrationKind>> kinds_{*this, "calibrationKinds"};
  Production<PublishedPoses> shownPoses_{*this, "calibrationPoses"};
  Production<std::vector<PublishedCapture>> shownCaptures_{*this, "calibrationCaptures"};
  Production<PublishedOutcome> shownOutcome_{*this, "calibrationOutcome"};
  Production<PublishedRuns> runs_{*this, "calibrationRuns"};

  PlayerState player_;
  bool playerKnown_ = false;
  std::optional<HeadLookRequest> followed_;
  std::uint64_t requests_ = 0, cycles_ = 0;
  std::uint64_t lookRequest_ = 0; // the last request that moved the head
  std::string runBefore_;         // previous value of `run`
  const CalibrationKind* kind_ = nullptr;
  CalibrationKind askedKind_; // kind that plays `poses`
  CalibrationJobs::Rounds rounds_;
  std::size_t round_ = 0, step_ = 0;
  std::map<std::string, int> taken_;           // in the current step, by camera
  std::map<CameraName, CameraFrame> previous_; // last images of the current step
  CaptureFaults faults_;                       // in the current round
  std::optional<TimePoint> roundStart_;
  std::optional<double> poseTime_;        // mean, of the current round or the previous one [s]
  TimePoint waitingSince_, pictureSince_; // start of the wait for a capture, time of the last image; in Clock
  CalibrationJobs jobs_;
};

} // namespace naocal
