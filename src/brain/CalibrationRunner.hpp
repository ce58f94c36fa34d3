#pragma once

#include "brain/BehaviorModule.hpp"
#include "brain/CalibrationInputs.hpp"
#include "brain/CalibrationJobs.hpp"
#include "brain/CalibrationStatus.hpp"
#include "brain/CaptureCollector.hpp"
#include "brain/Projection.hpp"
#include "framework/core/Module.hpp"
#include "framework/core/Parameter.hpp"
#include "hardware/messages/PoseRequest.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Calibrates the robot: takes poses before the boards, solves the captures, puts the joints' offsets and the cameras'
/// mounts into effect, takes a second, shorter round, and says how far the error of its pictures has fallen. Where that
/// is by half, it saves them; else it puts back what was before: the robot was well calibrated already, or something
/// else is off. What takes long is left to its jobs.
///
/// Started by its parameter `run` becoming the name of a kind of calibration (a value from the file starts nothing),
/// and ended by any other value; also by the chest button, which answers questions as well.
/// "poses" instead plays the poses of the parameter `poses` and records what is seen, and calibrates nothing.
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
  bool takePicture(); // if there is one, and all is still; else says what it waits for
  void waitFor(const char* what);
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
  Parameter<std::string> chestStarts_{*this, "chestStarts"}; // the kind; empty: none
  Parameter<std::vector<double>> yaws_{*this, "headYaws", checkEachWithin<-119, 119>},
      pitches_{*this, "headPitches", checkEachWithin<-38, 29>};         // [deg]
  Parameter<int> repeats_{*this, "repeats", checkWithin<1, 20>};        // pictures per camera and pose
  Parameter<int> checkPoses_{*this, "checkPoses", checkWithin<1, 100>}; // on each foot, to check
  Parameter<double> approach_{*this, "approach", checkWithin<0, 5>};    // from how far joints come into a pose [deg]
  Parameter<std::uint64_t> orderSeed_{*this, "seed"};                   // of the order of poses
  Parameter<double> settleTime_{*this, "settle", checkWithin<0, 10>};   // before a picture counts [s]
  Parameter<double> stillPicture_{*this, "stillPicture",
                                  checkWithin<0, 255>}; // a picture's most change since the last [grey]
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

  PlayerState player_;
  bool playerKnown_ = false;
  std::optional<HeadLookRequest> followed_;
  std::uint64_t requests_ = 0, cycles_ = 0;
  std::uint64_t lookRequest_ = 0; // the last one that made the robot look somewhere
  std::string runBefore_;         // the last value of `run`
  const CalibrationKind* kind_ = nullptr;
  CalibrationKind askedKind_; // that plays `poses`
  CalibrationJobs::Rounds rounds_;
  std::size_t round_ = 0, step_ = 0;
  std::map<std::string, int> taken_;           // in the present step, by camera
  std::map<CameraName, CameraFrame> previous_; // of the present step
  std::optional<TimePoint> roundStart_;
  std::optional<double> poseTime_;        // on the average of the present round, or the one before [s]
  TimePoint waitingSince_, pictureSince_; // for the next capture, since the last picture; in the program's time
  CalibrationJobs jobs_;
};

} // namespace naocal
