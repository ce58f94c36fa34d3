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

/// What the process is made of and where its files are.
struct RobotProcessOptions {
  std::filesystem::path configuration; // home/configuration; only read where `state` is another folder
  std::filesystem::path recordings;
  std::string location;                                 // empty: as sdk.json says
  std::optional<SocketSettings> sockets;                // absent: as sdk.json and access.json say
  bool realTime = true;                                 // ask the system to prefer the motion thread
  const ReplayWorld* replay = nullptr;                  // whose captures are to be taken anew, into `recordings`
  std::optional<std::uint16_t> basePort = std::nullopt; // instead of sdk.json's: debug one above, configuration two
  bool onlyHere = false;                                // listen on this computer only, whatever access.json says
  std::filesystem::path state = {}; // where what the robot learns is saved; empty: into the configuration itself
};

/// Both threads of the robot, wired and configured, with their sockets. Making it throws WiringError,
/// ConfigurationError or InputError with one sentence; nothing moves yet.
class RobotProcess {
public:
  /// `robot`, `cameras` and `drawing` must outlive it.
  RobotProcess(RobotInterface& robot, CameraInterface& cameras, const Robot& drawing, const RobotIdentity& identity,
               const RobotProcessOptions& options, Log log);
  ~RobotProcess(); // stops

  /// Runs both threads until `stop`. `failed` is called by a thread that ends by itself: something threw, or a replay
  /// is over (with an empty sentence).
  void start(std::function<void(std::string_view sentence)> failed);
  void stop();

  /// Has the robot go to its stand from wherever it is, while the motion thread runs. False where it has not come there
  /// in time, or cannot.
  bool goToStand(std::chrono::milliseconds most);

  /// Of a replay; nullptr where nothing is replayed.
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
  std::jthread motionThread_, brainThread_; // last: they use the others
};

} // namespace naocal
