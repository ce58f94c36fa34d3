#include "LegCalibrationTruth.hpp"

#include "dialects/SavedCalibration.hpp"
#include "math/Angles.hpp"
#include "runs/RobotHistory.hpp"

#include <catch2/catch.hpp>
#include <future>
#include <map>
#include <mutex>
#include <set>
#include <thread>

namespace naocal {

using nlohmann::json;

namespace {

/// Waits for a phase of a calibration that the client has subscribed to; fails if the calibration ends before.
json until(MateClient& debug, const std::string& phase) {
  json state = {{"phase", ""}};
  while (state["phase"] != phase) {
    REQUIRE(state["phase"] != "failed");
    REQUIRE(state["phase"] != "finished");
    state = json::parse(debug.receive(2).value().body).at(0)["value"];
  }
  return state;
}

/// All files and folders below a folder, with the files' content.
std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{folder}) {
    all[entry.path().string()] = entry.is_directory() ? "" : readFile(entry.path());
  }
  return all;
}

} // namespace

TEST_CASE("both threads are wired with the shipped configuration") {
  // Proves that every dependency has a producer and every parameter a value, and that nine important keys are listed.
  SimulatedProcess simulated{SimulatedProcess::plan(1, 0)};
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

TEST_CASE("a simulated robot calibrates neck and cameras, driven only through the sockets", "[robot]") {
  // Proves the whole workflow: started by SET, poses played, pictures paired and searched, solved, saved into the
  // robot's own files, and validated with further pictures; a second calibration changes nothing. Both are recorded as
  // runs with the errors that were told. Shipped files are only read. The robot's offsets are at most one degree.
  SimulatedProcess simulated{SimulatedProcess::plan(1, radians(1))};
  const auto shipped = contents(simulated.folder.path() / "configuration");
  const json state = simulated.calibrated("head");
  INFO(state.dump());
  REQUIRE(state["phase"] == "finished");
  CHECK(state["errorAfter"] < 0.3 * state["errorBefore"].get<double>());
  const json offsets = simulated.saved("default/body/synthetic-1/JointCalibrationProvider.json");
  CHECK(offsets.size() == 1); // the head's yaw is not observable on two feet
  CHECK(offsets.contains("headPitch"));
  const json mounts = simulated.saved("simulated/head/synthetic-1/Projection.json");
  CHECK(mounts.size() == 2);
  const json again = simulated.calibrated("head");
  CHECK(again["phase"] == "finished");
  CHECK(again["sentence"].get<std::string>().find("The robot was well calibrated already") == 0);
  CHECK(simulated.saved("simulated/head/synthetic-1/Projection.json") == mounts);
  CHECK(contents(simulated.folder.path() / "configuration") == shipped);
  const std::vector<Run> runs = simulated.runs();
  REQUIRE(runs.size() == 2);
  CHECK(runs[0].kind == "head");
  CHECK(runs[0].outcome == RunOutcome::kept);
  CHECK(runs[0].errorBefore == state["errorBefore"].get<double>());
  CHECK(runs[0].errorAfter == state["errorAfter"].get<double>());
  CHECK(runs[0].robot.body == "synthetic-1");
  CHECK(runs[0].set.at("HeadPitch") == Approx(radians(offsets["headPitch"].get<double>())));
  CHECK(runs[0].offsets.size() == 1);
  CHECK(runs[0].offsets.at("HeadPitch").sigma > 0);
  CHECK(std::filesystem::exists(runs[0].result));
  CHECK(runs[1].outcome == RunOutcome::unneeded);
}

TEST_CASE("offsets that a client saves are recorded as a run", "[robot]") {
  // Proves it for a client of the configuration's socket: values count once they are saved, and once only.
  SimulatedProcess simulated{SimulatedProcess::plan(1, 0)};
  simulated.process->start([](std::string_view) {});
  auto debug = MateClient::debug(simulated.process->sockets().debugPort());
  debug.send(0, "Brain.calibration");
  debug.send(3);
  debug.receive(4);
  debug.receive(2); // the brain has run
  auto config = MateClient::config(simulated.process->sockets().configPort());
  const auto saves = [&](double headPitch) {
    config.send(
        0,
        json::array({{{"mp", "Motion.JointCalibrationProvider"}, {"key", "headPitch"}, {"value", headPitch}}}).dump());
    config.send(3); // save
    config.send(1);
    config.receive(5); // was saved
  };
  const auto waitForRuns = [&](std::size_t count) {
    for (int i = 0; i < 3000 && simulated.runs().size() < count; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
    return simulated.runs();
  };
  saves(1.5);
  REQUIRE(waitForRuns(1).size() == 1);
  saves(1.5);
  saves(-0.5);
  const std::vector<Run> runs = waitForRuns(2);
  REQUIRE(runs.size() == 2);
  CHECK(runs[0].kind == applyKind);
  CHECK(runs[0].outcome == RunOutcome::kept);
  CHECK(runs[0].set.at("HeadPitch") == Approx(radians(1.5)));
  CHECK(runs[1].set.at("HeadPitch") == Approx(radians(-0.5)));
}

TEST_CASE("a calibration of neck and cameras that does not help is taken back", "[robot]") {
  // Proves it for a robot whose legs are off by up to five degrees: nothing is saved and offsets are restored; if a
  // client saved them before the validation, the former ones are saved again.
  const bool saves = GENERATE(false, true);
  SimulatedProcess simulated{SimulatedProcess::plan(4, radians(5))};
  bool saved = false;
  const json state = simulated.calibrated("head", [&](const json& now) {
    if (saves && !saved && now["captures"] > 26) { // in the second round
      simulated.process->configuration().save();
      saved = true;
    }
  });
  INFO(state.dump());
  REQUIRE(state["phase"] == "failed");
  CHECK(state["sentence"].get<std::string>().find("so the calibration was taken back") != std::string::npos);
  REQUIRE(simulated.runs().size() == 1);
  CHECK(simulated.runs().front().outcome == RunOutcome::takenBack);
  const char* file = "default/body/synthetic-4/JointCalibrationProvider.json";
  CHECK(simulated.isSaved(file) == saves);
  CHECK((!saves || simulated.saved(file)["headPitch"] == 0.0));
  json offsets;
  simulated.process->configuration().readKeys("Motion.JointCalibrationProvider", offsets);
  CHECK(offsets["headPitch"] == 0.0);
}

TEST_CASE("a simulated robot calibrates a leg on one foot, and what was saved can be undone", "[robot]") {
  // Proves the whole workflow for offsets up to 5 degrees, mounts up to 2 and gear play up to half a degree: the person
  // is asked before the robot steps onto the foot, pictures are taken from both approaches of each pose, and a floor
  // point 2 m ahead is then perceived within 2 cm, by the simulation's independent mechanics. Replaying the recording
  // gives bitwise equal estimates.
  SimulatedProcess simulated{SimulatedProcess::plan(1, radians(5), radians(0.5))};
  std::set<std::string> questions;
  const json state = simulated.calibrated("left leg", [&](const json& now) { questions.insert(now["question"]); });
  INFO(state.dump());
  REQUIRE(state["phase"] == "finished");
  CHECK(questions.size() == 4); // none; hold, release, hold
  CHECK(questions.contains("The robot is going to stand on its left foot and may fall: take it by its trunk, and "
                           "confirm. Hold it as long as its eyes are yellow."));
  CHECK(state["errorAfter"] < 0.3 * state["errorBefore"].get<double>());
  CHECK(state["robotSeconds"] < 240);
  const LegCalibrationTruth truth{simulated.drawing, simulated.world.errors(), ServoMechanics{}};
  CHECK(truth.floorError(SupportFoot::left, {}) > 0.05);
  CHECK(truth.floorError(SupportFoot::left, readConfiguredCalibration(simulated.process->configuration())) < 0.02);
  std::map<std::string, std::set<double>> sides; // approaches of the knee, by pose
  for (const Capture& capture : readCaptureSet(simulated.recording()).set.captures) {
    sides[capture.pose].insert(capture.joints.approach.at(*jointIndex("LKneePitch")));
  }
  CHECK(sides.size() == 8);
  for (const auto& [pose, both] : sides) {
    CHECK(both == std::set<double>{-1, 1});
  }
  const std::string body = "default/body/synthetic-1/JointCalibrationProvider.json";
  CHECK(simulated.saved(body)["lHipYawPitch"] == simulated.saved(body)["rHipYawPitch"]);
  CHECK(simulated.calibrated("undo")["phase"] == "finished");
  CHECK(simulated.saved(body).empty());
  const std::vector<RobotHistory> histories = makeHistories(simulated.runs());
  REQUIRE(histories.size() == 1);
  REQUIRE(histories.front().runs.size() == 1);
  CHECK(histories.front().runs.front().undone);
  CHECK(histories.front().joints.at("LKneePitch").size() == 1);

  const std::filesystem::path recording = simulated.recording().parent_path();
  CHECK(std::filesystem::exists(recording / "configuration/location/default/sdk.json"));
  CHECK(DrivenProcess::replayed(recording, simulated.folder.path() / "again")
            .find("estimates are the recorded ones, bit for bit.") != std::string::npos);
}

TEST_CASE("a question that is not answered keeps the robot on both feet, and any other run ends it") {
  // Proves that nothing moves before a confirmation; an old answer is ignored.
  SimulatedProcess simulated{SimulatedProcess::plan(1, 0)};
  auto config = MateClient::config(simulated.process->sockets().configPort());
  auto debug = MateClient::debug(simulated.process->sockets().debugPort());
  const auto set = [&](const char* key, const json& value) {
    config.send(0, json::array({{{"mp", "Brain.CalibrationRunner"}, {"key", key}, {"value", value}}}).dump());
  };
  debug.send(0, "Brain.calibration");
  simulated.process->start([](std::string_view) {});
  set("run", "right leg");
  const json waiting = until(debug, "waiting");
  CHECK(waiting["questionNumber"] == 1);
  set("confirmed", 7);
  const TimePoint asked = simulated.world.truth().time;
  while (simulated.world.truth().time < asked + std::chrono::seconds{5}) {
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
  }
  CHECK(simulated.world.truth().supportFoot == SupportFoot::both);
  set("run", "");
  CHECK(until(debug, "failed")["question"] == "");
  simulated.process->stop();
}

TEST_CASE("a calibration ends when the client that started it is gone", "[robot]") {
  // Proves it from a client's last will to the end of the calibration.
  SimulatedProcess simulated{SimulatedProcess::plan(1, 0)};
  std::optional<MateClient> config{MateClient::config(simulated.process->sockets().configPort())};
  auto debug = MateClient::debug(simulated.process->sockets().debugPort());
  const auto setting = [](const char* mount, const char* key, const json& value) {
    return json::array({{{"mp", mount}, {"key", key}, {"value", value}}});
  };
  debug.send(0, "Brain.calibration");
  simulated.process->start([](std::string_view) {});
  config->send(0, setting("naocal.configuration", "lastWill", setting("Brain.CalibrationRunner", "run", "")).dump());
  config->send(0, setting("Brain.CalibrationRunner", "run", "head").dump());
  until(debug, "collecting");
  config.reset();
  CHECK(until(debug, "failed")["sentence"].get<std::string>().find("The calibration was ended") == 0);
  simulated.process->stop();
}

} // namespace naocal
