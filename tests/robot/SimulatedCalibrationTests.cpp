#include "MateClient.hpp"
#include "TemporaryFolder.hpp"
#include "captures/CaptureSetFile.hpp"
#include "captures/Files.hpp"
#include "hardware/simulated/SimulatedWorld.hpp"

#include "RobotProcess.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using nlohmann::json;

/// The process as it is shipped, on a simulated robot as fast as it goes, with a configuration and recordings of its
/// own.
struct SimulatedProcess {
  SimulatedProcess(std::uint64_t seed, double offsetRange)
      : world{drawing, plan(seed, offsetRange)}, robot{world.robot()}, cameras{world.cameras()} {
    std::filesystem::copy(std::filesystem::path{NAOCAL_SOURCE_DIR} / "home/configuration",
                          folder.path() / "configuration", std::filesystem::copy_options::recursive);
    SocketSettings sockets;
    sockets.debugPort = sockets.configPort = 0;
    process.emplace(
        *robot, *cameras, drawing, robot->waitForIdentity(std::chrono::seconds{1}).value(),
        RobotProcessOptions{folder.path() / "configuration", folder.path() / "recordings", "simulated", sockets, false},
        [](std::string_view) {});
  }
  static SimulatedPlan plan(std::uint64_t seed, double offsetRange) {
    SimulatedPlan plan;
    plan.seed = seed;
    plan.offsetRange = offsetRange;
    plan.pace = Pace::quick;
    return plan;
  }

  /// Starts a calibration over the sockets and waits for its end; the last state that it told.
  json calibrated() {
    auto debug = MateClient::debug(process->sockets().debugPort());
    auto config = MateClient::config(process->sockets().configPort());
    debug.send(0, "Brain.calibration");
    debug.send(3);
    debug.receive(4);
    process->start([](std::string_view) {});
    config.send(0, R"([{"mp": "Brain.CalibrationRunner", "key": "run", "value": "head"}])");
    json state = {{"phase", "idle"}};
    while (state["phase"] != "finished" && state["phase"] != "failed") {
      const auto update = debug.receive(2);
      if (!update) {
        return {{"phase", "the robot fell silent"}};
      }
      state = json::parse(update->body).at(0)["value"];
    }
    process->stop();
    return state;
  }
  json saved(const std::string& file) const {
    return json::parse(fileContent(folder.path() / "configuration/location" / file));
  }

  TemporaryFolder folder;
  Robot drawing = loadRobot(configurationDirectory(), "V6");
  SimulatedWorld world;
  std::unique_ptr<RobotInterface> robot;
  std::unique_ptr<CameraInterface> cameras;
  std::optional<RobotProcess> process;
};

} // namespace

TEST_CASE("both threads are wired with the shipped configuration") {
  // Proves that every dependency has its producer and every parameter its value, and that all keys are served.
  SimulatedProcess simulated{1, 0};
  auto debug = MateClient::debug(simulated.process->sockets().debugPort());
  debug.send(3);
  const json list = debug.receiveJson(4);
  std::set<std::string> keys;
  for (const json& entry : list["keys"]) {
    keys.insert(entry["key"].get<std::string>());
  }
  for (const char* key : {"Motion.JointCalibrationData", "Motion.angles", "Motion.player", "Motion.measuredCycleTime",
                          "Brain.CameraCalibration.top_image", "Brain.CameraCalibration.bottom_image", "Brain.cameras",
                          "Brain.calibration", "Brain.measuredCycleTime"}) {
    CHECK(keys.contains(key));
  }
}

TEST_CASE("a simulated robot calibrates neck and cameras, driven only through the sockets") {
  // Proves the whole way: started by a SET, poses played, pictures paired and searched, solved, saved into the robot's
  // own files, and checked with pictures that were not used. Its legs are nearly calibrated (within a degree).
  SimulatedProcess simulated{1, radians(1)};
  const json state = simulated.calibrated();
  INFO(state.dump());
  REQUIRE(state["phase"] == "finished");
  CHECK(state["errorAfter"] < 0.3 * state["errorBefore"].get<double>());
  CHECK(simulated.saved("default/body/synthetic-1/JointCalibrationProvider.json").size() == 2);
  CHECK(simulated.saved("simulated/head/synthetic-1/Projection.json").size() == 2);
}

TEST_CASE("a calibration of neck and cameras that does not help is taken back") {
  // Proves it for a robot whose legs are off by up to five degrees: what was saved is undone, files and offsets.
  SimulatedProcess simulated{4, radians(5)};
  const json state = simulated.calibrated();
  INFO(state.dump());
  REQUIRE(state["phase"] == "failed");
  CHECK(state["sentence"].get<std::string>().find("so the calibration was taken back") != std::string::npos);
  CHECK(simulated.saved("default/body/synthetic-4/JointCalibrationProvider.json").empty());
  json offsets;
  simulated.process->configuration().keys("Motion.JointCalibrationProvider", offsets);
  CHECK(offsets["headPitch"] == 0.0);
}

} // namespace naocal
