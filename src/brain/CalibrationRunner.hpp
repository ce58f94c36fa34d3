#pragma once

#include "brain/CalibrationBoards.hpp"
#include "brain/CalibrationSession.hpp"
#include "brain/CalibrationState.hpp"
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

#include <map>
#include <memory>

namespace naocal {

/// What a calibration needs beside its parameters.
struct CalibrationSurroundings {
  const Robot& drawing;
  RobotIdentity identity;
  Configuration& configuration;     // where results are applied and saved
  std::filesystem::path recordings; // folder that gets one folder per calibration
};

/// Calibrates neck and cameras of a robot that stands on both feet and whose legs are calibrated: it looks around at
/// the boards, the captures are solved, the neck's offsets and the cameras' mounts are saved, it looks once more
/// elsewhere, and says how far the error has fallen. Where that is not by half, what was saved is taken back. Detection
/// and solving are done by a thread of their own.
///
/// Started by its parameter `run` becoming "head" (a value from the file starts nothing), and ended by any other value.
class CalibrationRunner final : public Module {
public:
  explicit CalibrationRunner(CalibrationSurroundings surroundings);
  void cycle() override;
  void parametersChanged() override;

private:
  /// A round's session, made and used by the worker alone.
  struct Round {
    std::optional<CalibrationSession> session;
  };
  /// What the worker found out.
  struct Finding {
    std::filesystem::path folder; // of the calibration that it is about
    bool isApplied = false;
    std::optional<CalibrationSession::Error> error;
    std::string problem; // one sentence; empty: none
  };
  void start();
  void enter(CalibrationState::Phase phase, const std::string& sentence);
  void startRound(std::shared_ptr<Round>& round, const std::string& name);
  void ask(PoseRequest::Kind kind, const std::string& name, std::vector<CompensatedAngles> points);
  void watchPlayer();
  void goOn();
  void nextPose();
  void collect();
  void solve();
  void check();
  void takeFinding();
  void tellError(const CalibrationSession::Error& error);
  CaptureSet header() const;
  /// Has the worker do it; what it finds or throws comes back as a finding.
  void give(std::function<void(Finding&)> task);

  Parameter<std::string> run_{*this, "run"};
  Parameter<std::vector<double>> yaws_{*this, "headYaws"}, pitches_{*this, "headPitches"}; // [deg]
  Parameter<int> repeats_{*this, "repeats"};      // pictures per camera and pose
  Parameter<double> settleTime_{*this, "settle"}; // before a picture counts [s]
  Parameter<CalibrationBoards> boards_{*this, "boards"};
  Dependency<StillPicture> picture_{*this, "stillPicture"};
  Dependency<CameraBeliefs> cameras_{*this, "cameras"};
  Dependency<Latest<PlayerState>> playerUpdates_{*this, "Motion.playerForBrain"};
  Production<Latest<PoseRequest>> request_{*this, "poseRequest"};
  Production<CalibrationState> state_{*this, "calibration"};

  CalibrationSurroundings surroundings_;
  PlayerState player_;
  std::uint64_t requests_ = 0;
  std::string asked_; // the last value of `run`
  bool configured_ = false;
  std::filesystem::path folder_;
  std::vector<CompensatedAngles> poses_;
  std::map<std::string, int> taken_; // of the present pose, by camera
  std::optional<TimePoint> roundStart_;
  std::shared_ptr<Round> first_, second_; // their sessions belong to the worker
  Latest<Finding> findings_;
  Worker worker_; // last: it uses the others
};

} // namespace naocal
