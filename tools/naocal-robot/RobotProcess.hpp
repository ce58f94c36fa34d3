#pragma once

#include "brain/BrainModules.hpp"
#include "brain/ReplayedCalibration.hpp"
#include "framework/configuration/Configuration.hpp"
#include "framework/core/Database.hpp"
#include "framework/core/Thread.hpp"
#include "framework/network/Sockets.hpp"
#include "hardware/CameraInterface.hpp"
#include "hardware/RobotInterface.hpp"
#include "motion/PosePlayer.hpp"

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

namespace naocal {

/// Configuration, output folders and sockets of the process.
struct RobotProcessOptions {
  std::filesystem::path configuration; // home/configuration; read-only if `state` is another folder
  std::filesystem::path recordings;
  std::string location;                                 // empty: as in sdk.json
  std::optional<SocketSettings> sockets;                // absent: as in sdk.json and access.json
  bool realTime = true;                                 // request real-time priority for the motion thread
  const ReplayWorld* replay = nullptr;                  // recording to calibrate again, into `recordings`
  std::optional<std::uint16_t> basePort = std::nullopt; // overrides sdk.json: debug one above, configuration two
  bool onlyHere = false;                                // listen on this computer only, overrides access.json
  std::filesystem::path state = {};                     // folder of saved settings; empty: the configuration itself
};

/// The robot's two threads, wired and configured, with their sockets. The constructor moves nothing; it throws
/// WiringError, ConfigurationError or InputError with one sentence.
class RobotProcess {
public:
  /// `robot`, `cameras` and `drawing` must outlive it.
  RobotProcess(RobotInterface& robot, CameraInterface& cameras, const Robot& drawing, const RobotIdentity& identity,
               const RobotProcessOptions& options, Log log);
  ~RobotProcess(); // stops

  /// Runs both threads until `stop`. A thread that ends by itself calls `failed`: after an exception, or at the end of
  /// a replay (empty sentence).
  void start(std::function<void(std::string_view sentence)> failed);
  void stop();

  /// Moves the robot to its stand while the motion thread runs. False if it does not arrive within `most`.
  bool goToStand(std::chrono::milliseconds most);

  /// nullptr without a replay.
  ReplayedCalibration* replayed() { return replayed_; }

  SocketServers& sockets() { return *sockets_; }
  Configuration& configuration() { return configuration_; }
  Thread& motion() { return motion_; }
  Thread& brain() { return brain_; }

private:
  void run(Thread& thread, const std::stop_token& stop, const std::function<bool()>& ended);

  RobotInterface& robot_;
  CameraInterface& cameras_;
  RobotProcessOptions options_;
  Log log_;
  Configuration configuration_;
  ShutdownRequest ending_;
  Thread motion_{"Motion", RobotPart::body}, brain_{"Brain", RobotPart::head};
  ReplayedCalibration* replayed_ = nullptr;
  std::optional<Database> database_;
  std::optional<SocketServers> sockets_;
  std::function<void(std::string_view)> failed_;
  std::atomic<bool> moves_{false};          // the motion thread runs
  std::jthread motionThread_, brainThread_; // last: they use the members above
};

} // namespace naocal
