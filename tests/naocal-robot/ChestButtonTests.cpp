#include "SimulatedProcess.hpp"

#include "math/Angles.hpp"

#include <catch2/catch.hpp>
#include <functional>

namespace naocal {

using nlohmann::json;

namespace {

/// A person with access to the chest button; the sockets are used for reading only.
struct Person {
  explicit Person(const SimulatedPlan& plan)
      : simulated{plan}, debug{MateClient::debug(simulated.process->sockets().debugPort())} {
    debug.send(0, "Brain.calibration");
    debug.send(3);
    debug.receive(4);
    simulated.process->start([](std::string_view) {});
  }
  ~Person() { simulated.process->stop(); }

  void set(const char* key, const json& value) {
    simulated.process->configuration().set("Brain.CalibrationRunner", key, value);
  }
  /// Sets the calibration started by the chest button, and waits for a complete cycle of the brain.
  void setStart(const char* kind) {
    set("chestStarts", kind);
    wait(0.2);
  }
  void wait(double time) { // robot's time [s]
    const TimePoint end = simulated.world.truth().time + fromSeconds(time);
    while (simulated.world.truth().time < end) {
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
  }
  void press() {
    Touch touch;
    touch.chestButton = true;
    simulated.world.touch(touch);
    wait(0.1);
    simulated.world.touch({});
    wait(0.1);
  }
  /// The next published state.
  json next() { return json::parse(debug.receive(2).value().body).at(0)["value"]; }
  /// Waits for a state that satisfies the predicate; fails if the calibration ends before.
  json until(const std::function<bool(const json&)>& isSo) {
    json state = next();
    while (!isSo(state)) {
      INFO(state.dump());
      REQUIRE(state["phase"] != "failed");
      REQUIRE(state["phase"] != "finished");
      state = next();
    }
    return state;
  }
  json until(const std::string& phase) {
    return until([&](const json& state) { return state["phase"] == phase; });
  }

  SimulatedProcess simulated;
  MateClient debug;
};

} // namespace

TEST_CASE("the chest button alone calibrates a leg: it starts, and answers every question", "[robot]") {
  // Proves it with offsets up to 5 degrees. Setting other parameters meanwhile does not end the calibration, and
  // nothing is saved before the second round has validated it.
  Person person{SimulatedProcess::plan(1, radians(5))};
  person.setStart("left leg");
  person.press();
  int answered = 0;
  const char* file = "default/body/synthetic-1/JointCalibrationProvider.json";
  json state = person.until("waiting");
  CHECK(state["questionNumber"] == 1);
  while (state["phase"] != "finished") {
    INFO(state.dump());
    REQUIRE(state["phase"] != "failed");
    if (state["phase"] == "waiting" && state["questionNumber"] > answered) {
      answered = state["questionNumber"];
      person.set("settle", 0.29 + 0.01 * answered);
      person.press();
    } else if (state["phase"] != "checking") {
      CHECK_FALSE(person.simulated.isSaved(file));
    }
    state = person.next();
  }
  CHECK(answered == 6); // hold, release, hold: in both rounds
  CHECK(person.simulated.isSaved(file));
  CHECK(state["errorAfter"] < 0.3 * state["errorBefore"].get<double>());
}

TEST_CASE("a calibration that the chest button started is ended by its parameter, whatever that was before",
          "[robot]") {
  // Proves it for an unchanged parameter value, and that question numbers continue after an old answer's.
  Person person{SimulatedProcess::plan(1, 0)};
  person.set("confirmed", 5);
  person.setStart("left leg");
  person.press();
  CHECK(person.until("waiting")["questionNumber"] == 6);
  person.set("run", "");
  CHECK(person.until("failed")["sentence"] ==
        "The calibration was ended; the robot goes back to its stand. Nothing was changed.");
}

TEST_CASE("a calibration that is ended while its ways are checked stays ended, and says so") {
  // Proves that results computed after the end are neither used nor reported.
  Person person{SimulatedProcess::plan(1, 0)};
  person.set("run", "left leg");
  person.until([](const json& one) { return one["phase"] == "preparing" || one["phase"] == "waiting"; });
  person.set("run", "");
  json state = person.until("failed");
  for (int i = 0; i < 150; ++i) { // longer than the path check takes
    state = person.next();
  }
  CHECK(state["phase"] == "failed");
  CHECK(state["sentence"] == "The calibration was ended; the robot goes back to its stand. Nothing was changed.");
}

TEST_CASE("a robot that is ended on one foot is held on its way back", "[robot]") {
  // Proves for a robot with offsets up to 5 degrees, which falls between one foot and both unless held, that it asks to
  // be held first and reaches its stand, even with a request for camera motion meanwhile.
  Person person{SimulatedProcess::plan(1, radians(5))};
  person.set("run", "left leg");
  int answered = 0;
  person.until([&](const json& state) {
    if (state["phase"] == "waiting" && state["questionNumber"] > answered) {
      answered = state["questionNumber"];
      person.set("confirmed", answered);
    }
    return state["phase"] == "collecting" && state["pose"] >= 2;
  });
  CHECK(person.simulated.world.truth().supportFoot == SupportFoot::left);
  person.simulated.process->configuration().set("Brain.BehaviorModule", "isCameraCalibration", true); // must have no
                                                                                                      // effect now
  auto player = MateClient::debug(person.simulated.process->sockets().debugPort()); // a silent client is sent away
  player.send(0, "Motion.player"); // before the end, so that nothing of the way back is missed
  person.set("run", "");
  const auto next = [&] { return json::parse(player.receive(2).value().body).at(0)["value"]; };
  bool asked = false;
  for (json now = next(); now["atHome"] != true && now["phase"] != "fallen"; now = next()) {
    asked = asked || (now["held"] == true && now["phase"] == "holding");
  }
  CHECK(asked);
  person.wait(1); // released
  CHECK_FALSE(person.simulated.world.truth().fallen);
  CHECK(person.simulated.world.truth().supportFoot == SupportFoot::both);
}

TEST_CASE("a calibration says what it waits for", "[robot]") {
  // Proves it for a camera without pictures.
  Person person{SimulatedProcess::plan(1, 0)};
  person.simulated.world.block(CameraName::bottom, true);
  person.set("run", "head");
  const json state = person.until(
      [](const json& one) { return one["sentence"].get<std::string>().find("waits until") != std::string::npos; });
  CHECK(state["sentence"] == "Pose H00 waits until the bottom camera gives pictures.");
  person.simulated.world.block(CameraName::bottom, false);
  CHECK(person.until("finished")["errorAfter"].is_number());
}

} // namespace naocal
