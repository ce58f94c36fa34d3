#pragma once

#include "MateClient.hpp"
#include "TemporaryFolder.hpp"
#include "io/Files.hpp"
#include "robot/Robot.hpp"
#include "runs/RunFolder.hpp"

#include "Hardware.hpp"
#include "RobotProcess.hpp"

#include <future>
#include <mutex>
#include <nlohmann/json.hpp>

namespace naocal {

/// The process as shipped, with temporary configuration, state and recordings, driven through its sockets.
struct DrivenProcess {
  using Json = nlohmann::json;

  /// `now`: clock of the robot.
  void begin(RobotInterface& robot, CameraInterface& cameras, const Robot& drawing, std::function<TimePoint()> now,
             bool realTime = false) {
    std::filesystem::copy(std::filesystem::path{NAOCAL_SOURCE_DIR} / "home/configuration",
                          folder.path() / "configuration", std::filesystem::copy_options::recursive);
    SocketSettings sockets;
    sockets.debugPort = sockets.configPort = 0;
    robotNow = std::move(now);
    RobotProcessOptions options{folder.path() / "configuration", folder.path() / "recordings", "simulated", sockets,
                                realTime};
    options.state = folder.path() / "state";
    process.emplace(robot, cameras, drawing, robot.waitForIdentity(std::chrono::minutes{5}).value(), options,
                    [this](std::string_view line) { log += std::string{line} + "\n"; });
  }

  /// Starts a calibration through the sockets, answers its questions and waits for its end. Returns the last state,
  /// plus `robotSeconds`: time in which the robot moved, settled and took pictures, by its own clock; computing time is
  /// meaningless if that clock is simulated.
  /// `see`: called with every state.
  Json calibrated(const std::string& kind, const std::function<void(const Json&)>& see = {}) {
    auto debug = MateClient::debug(process->sockets().debugPort());
    auto config = MateClient::config(process->sockets().configPort());
    const auto set = [&](const char* key, const Json& value) {
      config.send(0, Json::array({{{"mp", "Brain.CalibrationRunner"}, {"key", key}, {"value", value}}}).dump());
    };
    debug.send(0, "Brain.calibration");
    debug.send(3);
    debug.receive(4);
    process->start([](std::string_view) {});
    set("run", ""); // resets the key first: only changes have an effect
    set("run", kind);
    Json state = {{"phase", "idle"}};
    int answered = 0;
    TimePoint last = robotNow();
    double moving = 0; // [s]
    bool begun = false;
    while (!begun || (state["phase"] != "finished" && state["phase"] != "failed")) {
      const auto update = debug.receive(2);
      if (!update) {
        return {{"phase", "the robot fell silent"}};
      }
      state = Json::parse(update->body).at(0)["value"];
      begun = begun || state != told; // otherwise it is still the end of the previous calibration
      const TimePoint now = robotNow();
      if (state["phase"] == "moving" || state["phase"] == "collecting" || state["phase"] == "going home") {
        moving += toSeconds(now - last);
      }
      last = now;
      state["robotSeconds"] = moving;
      if (state["phase"] == "waiting" && state["questionNumber"] != answered) {
        answered = state["questionNumber"];
        set("confirmed", answered);
      }
      if (see) {
        see(state);
      }
    }
    process->stop();
    told = state;
    told.erase("robotSeconds");
    return state;
  }
  bool isSaved(const std::string& file) const {
    return std::filesystem::exists(folder.path() / "state/location" / file);
  }
  Json saved(const std::string& file) const { return Json::parse(readFile(folder.path() / "state/location" / file)); }
  /// The recorded runs.
  std::vector<Run> runs() const { return RunFolder{runsIn(folder.path() / "state")}.read().runs; }
  /// Recording of the last calibration's first round.
  std::filesystem::path recording() const {
    std::filesystem::path newest;
    for (const auto& entry : std::filesystem::directory_iterator{folder.path() / "recordings"}) {
      newest = std::max(newest, entry.path());
    }
    return newest / "first";
  }

  /// Replays a calibration's first round with the recorded configuration. Returns the final comparison or the failure.
  static std::string replayed(const std::filesystem::path& recording, const std::filesystem::path& folder) {
    const Hardware hardware = replayedHardware(recording / "first", recording / "configuration");
    SocketSettings sockets;
    sockets.debugPort = sockets.configPort = 0;
    RobotProcess process{
        *hardware.robot,
        *hardware.cameras,
        hardware.drawing,
        hardware.robot->waitForIdentity(std::chrono::minutes{5}).value(),
        RobotProcessOptions{recording / "configuration", folder, "simulated", sockets, false, hardware.replay.get()},
        [](std::string_view) {}};
    std::promise<std::string> over;
    std::once_flag once;
    process.start(
        [&](std::string_view sentence) { std::call_once(once, [&] { over.set_value(std::string{sentence}); }); });
    const std::string failure = over.get_future().get();
    process.stop();
    return failure.empty() ? process.replayed()->compareWith(recording / "first" / "result.json") : failure;
  }

  TemporaryFolder folder;
  std::function<TimePoint()> robotNow;
  Json told;       // final state of the last calibration
  std::string log; // read only after the process has ended
  std::optional<RobotProcess> process;
};

} // namespace naocal
