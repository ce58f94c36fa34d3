#pragma once

#include "brain/AskedPoses.hpp"
#include "brain/BehaviorModule.hpp"
#include "brain/CalibrationBoards.hpp"
#include "brain/CalibrationKind.hpp"
#include "brain/CalibrationSession.hpp"
#include "brain/CalibrationShown.hpp"
#include "brain/CalibrationState.hpp"
#include "brain/CalibrationStep.hpp"
#include "brain/Projection.hpp"
#include "brain/StillPicture.hpp"
#include "brain/Worker.hpp"
#include "framework/Configuration.hpp"
#include "framework/Dependency.hpp"
#include "framework/Module.hpp"
#include "framework/Parameter.hpp"
#include "framework/Production.hpp"
#include "hardware/RobotInterface.hpp"
#include "hardware/exchange/PoseRequest.hpp"

#include <array>
#include <map>
#include <memory>

namespace naocal {

/// What a calibration needs beside its parameters.
struct CalibrationSurroundings {
  const Robot& drawing;
  RobotIdentity identity;
  Configuration& configuration;     // where results are applied and saved
  std::filesystem::path files;      // the configuration's folder, copied into recordings; poses/V6.json and so on
  std::filesystem::path recordings; // folder that gets one folder per calibration
};

/// Calibrates the robot: takes poses before the boards, solves the captures, saves the joints' offsets and the cameras'
/// mounts, takes a second, shorter round, and says how far the error of its pictures has fallen. Where that is not by
/// half, what was saved is taken back: it was well calibrated already, or something else is off. Checking ways, detection and solving are done by a thread of their own.
///
/// Started by its parameter `run` becoming the name of a kind of calibration (a value from the file starts nothing),
/// and ended by any other value; also by the chest button, which answers questions as well.
/// "poses" instead plays the poses of the parameter `poses` and records what is seen, and calibrates nothing.
class CalibrationRunner final : public Module {
public:
  explicit CalibrationRunner(CalibrationSurroundings surroundings);
  void cycle() override;
  void parametersChanged() override;

private:
  using Rounds = std::array<CalibrationRound, 2>; // to calibrate, to check
  /// A round's session, made and used by the worker alone.
  struct Round {
    std::optional<CalibrationSession> session;
  };
  /// What the worker found out.
  struct Finding {
    std::filesystem::path folder; // of the calibration that it is about
    std::optional<Rounds> rounds;
    bool isApplied = false;
    std::optional<ShownOutcome> outcome;
    std::optional<CalibrationSession::Error> error;
    std::string problem; // one sentence; empty: none
  };
  /// What was found in the captures of a calibration so far, in their order.
  struct Looked {
    std::filesystem::path folder; // of that calibration
    std::vector<ShownCapture> captures;
  };
  void start(const CalibrationKind& kind);
  void prepare();
  void undo();
  void startAskedPoses();
  void enter(CalibrationState::Phase phase, const std::string& sentence);
  void fail(const std::string& sentence);
  void startRound();
  void nextStep();
  void go();
  void ask(PoseRequest::Kind kind, const std::string& name, std::vector<CompensatedAngles> points, bool held = false);
  void watchPlayer();
  void chestPressed();
  void follow(const WantedLook& look);
  bool isStill(const CameraFrame& frame);
  void collect();
  void endStep();
  void endRound();
  void solve();
  void check();
  void takeFinding();
  void take(const Capture& capture);
  void takeLooked();
  void tellError(const CalibrationSession::Error& error);
  CaptureSet header() const;
  /// Has the worker do it; what it finds or throws comes back as a finding.
  void give(std::function<void(Finding&)> task);

  Parameter<std::string> run_{*this, "run"};
  Parameter<int> confirmed_{*this, "confirmed"};
  Parameter<AskedPoses> askedPoses_{*this, "poses"};
  Parameter<std::string> chestStarts_{*this, "chestStarts"};                               // the kind; empty: none
  Parameter<std::vector<double>> yaws_{*this, "headYaws"}, pitches_{*this, "headPitches"}; // [deg]
  Parameter<int> repeats_{*this, "repeats"};              // pictures per camera and pose
  Parameter<int> checkPoses_{*this, "checkPoses"};        // on each foot, to check
  Parameter<double> approach_{*this, "approach"};         // from how far joints come into a pose on one foot [deg]
  Parameter<std::uint64_t> orderSeed_{*this, "seed"};     // of the order of poses
  Parameter<double> settleTime_{*this, "settle"};         // before a picture counts [s]
  Parameter<double> stillPicture_{*this, "stillPicture"}; // how far a picture may differ from the one before it [grey]
  Parameter<CalibrationBoards> boards_{*this, "boards"};
  Dependency<StillPicture> picture_{*this, "stillPicture"};
  Dependency<CameraBeliefs> cameras_{*this, "cameras"};
  Dependency<WantedLook> look_{*this, "wantedLook"};
  Dependency<Latest<PlayerState>> playerUpdates_{*this, "Motion.playerForBrain"};
  Production<Latest<PoseRequest>> request_{*this, "poseRequest"};
  Production<CalibrationState> state_{*this, "calibration"};
  Production<std::vector<CalibrationKind>> kinds_{*this, "calibrationKinds"};
  Production<ShownPoses> shownPoses_{*this, "calibrationPoses"};
  Production<std::vector<ShownCapture>> shownCaptures_{*this, "calibrationCaptures"};
  Production<ShownOutcome> shownOutcome_{*this, "calibrationOutcome"};

  CalibrationSurroundings surroundings_;
  PlayerState player_;
  bool playerKnown_ = false;
  WantedLook followed_;
  std::uint64_t requests_ = 0, cycles_ = 0;
  std::string asked_; // the last value of `run`
  bool configured_ = false;
  const CalibrationKind* kind_ = nullptr;
  CalibrationKind askedKind_; // that plays `poses`
  std::filesystem::path folder_;
  Rounds rounds_;
  std::size_t round_ = 0, step_ = 0;
  std::map<std::string, int> taken_;           // in the present step, by camera
  std::map<CameraName, CameraFrame> previous_; // of the present step
  std::optional<TimePoint> roundStart_;
  std::array<std::shared_ptr<Round>, 2> sessions_; // belong to the worker
  StoredResult before_;                            // as configured before
  Latest<Finding> findings_;
  Latest<Looked> looked_;
  Looked lookedAt_; // the worker's
  Worker worker_;   // last: it uses the others
};

} // namespace naocal
