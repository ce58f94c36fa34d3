#include "SimulatedProcess.hpp"

#include "math/Angles.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <mutex>
#include <utility>

namespace naocal {

using nlohmann::json;

namespace {

/// A simulated robot whose states are changed on their way to the program.
class FaultyRobot : public RobotInterface {
public:
  using Fault = std::function<void(RobotState&)>;

  explicit FaultyRobot(std::unique_ptr<RobotInterface> robot) : robot_{std::move(robot)} {}
  std::optional<RobotIdentity> waitForIdentity(std::chrono::milliseconds timeout) override {
    return robot_->waitForIdentity(timeout);
  }
  std::optional<RobotState> waitForState(std::chrono::milliseconds timeout) override {
    auto state = robot_->waitForState(timeout);
    const std::lock_guard lock{mutex_};
    if (state && fault_) {
      fault_(*state);
    }
    return isSilent_ ? std::nullopt : state;
  }
  void send(const RobotCommand& command) override { robot_->send(command); }
  std::chrono::nanoseconds period() const override { return robot_->period(); }
  RobotStatus status() const override { return robot_->status(); }

  void inject(Fault fault) {
    const std::lock_guard lock{mutex_};
    fault_ = std::move(fault);
  }
  /// States do not arrive any more, or again.
  void silence(bool isSilent) {
    const std::lock_guard lock{mutex_};
    isSilent_ = isSilent;
  }

private:
  std::unique_ptr<RobotInterface> robot_;
  std::mutex mutex_;
  Fault fault_;
  bool isSilent_ = false;
};

/// Simulated cameras of which one may repeat its last picture or be covered.
class FaultyCameras : public CameraInterface {
public:
  enum class Fault { none, frozen, black };

  explicit FaultyCameras(std::unique_ptr<CameraInterface> cameras) : cameras_{std::move(cameras)} {}
  std::optional<CameraFrame> waitForFrame(std::chrono::milliseconds timeout) override {
    auto frame = cameras_->waitForFrame(timeout);
    if (!frame || frame->camera != CameraName::top) {
      return frame;
    }
    switch (fault.load()) {
    case Fault::none:
      last_ = frame->picture;
      break;
    case Fault::frozen:
      frame->picture = last_;
      break;
    case Fault::black:
      frame->picture = std::make_shared<Black>(frame->picture->bytes().size());
    }
    return frame;
  }
  CameraStatus status(CameraName camera) const override { return cameras_->status(camera); }

  std::atomic<Fault> fault{Fault::none}; // of the top camera

private:
  struct Black : ImageBytes { // YUYV
    explicit Black(std::size_t size) : all(size, 0) {}
    std::span<const std::uint8_t> bytes() const override { return all; }
    std::vector<std::uint8_t> all;
  };
  std::unique_ptr<CameraInterface> cameras_;
  std::shared_ptr<const ImageBytes> last_;
};

/// The process on that robot, which calibrates neck and cameras, watched by an operator.
struct Faulty : DrivenProcess {
  Faulty() : world{drawing, SimulatedProcess::plan(1, radians(1))}, robot{world.robot()}, cameras{world.cameras()} {
    begin(robot, cameras, drawing, [this] { return world.truth().time; });
    debug.emplace(MateClient::debug(process->sockets().debugPort()));
    debug->send(0, "Brain.calibration");
    debug->send(0, "Motion.player");
    debug->send(3);
    debug->receive(4);
    process->start([](std::string_view) {});
    process->configuration().set("Brain.CalibrationRunner", "run", "head");
  }
  ~Faulty() { process.reset(); }

  /// Waits for a state of the calibration that satisfies the predicate, or for its end.
  json until(const std::function<bool(const json&)>& isSo) {
    for (;;) {
      const auto update = debug->receive(2);
      if (!update) {
        return {{"phase", "silent"}, {"sentence", ""}};
      }
      for (const json& value : json::parse(update->body)) {
        if (value["key"] == "Motion.player") {
          player = value["value"];
        } else if (const json& state = value["value"];
                   isSo(state) || state["phase"] == "failed" || state["phase"] == "finished") {
          return state;
        }
      }
    }
  }
  json untilPose(int pose) {
    return until([&](const json& state) { return state["phase"] == "collecting" && state["pose"] >= pose; });
  }
  std::string untilSaid(const std::string& text) {
    return until([&](const json& state) {
      return state["sentence"].get<std::string>().find(text) != std::string::npos;
    })["sentence"];
  }
  /// Whether the player comes to a state with this value within 5000 updates.
  bool playerComesTo(const char* key, const json& value) {
    for (int i = 0; i < 5000 && player.value(key, json{}) != value; ++i) {
      const auto update = debug->receive(2);
      for (const json& one : update ? json::parse(update->body) : json::array()) {
        player = one["key"] == "Motion.player" ? one["value"] : player;
      }
    }
    return player.value(key, json{}) == value;
  }
  bool comesHome() { return playerComesTo("atHome", true); }
  bool hasChanged() const { return isSaved("default/body/synthetic-1/JointCalibrationProvider.json"); }

  Robot drawing = loadRobot(configurationDirectory(), "V6");
  SimulatedWorld world;
  FaultyRobot robot;
  FaultyCameras cameras;
  std::optional<MateClient> debug;
  json player = json::object();
};

} // namespace

TEST_CASE("a fault of the robot ends a calibration with a sentence, a robot at its stand, and nothing changed",
          "[robot]") {
  // Proves it for faults of joints, sensors and the floor that begin while pictures are taken.
  struct Case {
    FaultyRobot::Fault fault;
    const char* sentence;
  };
  const Case one = GENERATE(
      Case{[](RobotState& state) { state.angles[*jointIndex("HeadPitch")] = radians(40); },
           "The calibration ended. HeadPitch does not follow: it was sent to "},
      Case{[](RobotState& state) { state.accelerometer.setZero(); },
           "The calibration ended. The inertial unit gives no true values, so that a fall would not be noticed."},
      Case{[](RobotState& state) { state.temperature[*jointIndex("LKneePitch")] = 85; },
           "The calibration ended. LKneePitch is 85 degrees Celsius hot: the robot goes back to its stand."},
      Case{[](RobotState& state) { state.forces.fill(0); }, "The robot was lifted: its feet carry nothing"});
  CAPTURE(one.sentence);
  Faulty faulty;
  REQUIRE(faulty.untilPose(2)["phase"] == "collecting");
  faulty.robot.inject(one.fault);
  const json state = faulty.until([](const json&) { return false; });
  CHECK(state["phase"] == "failed");
  CHECK(state["sentence"].get<std::string>().starts_with(one.sentence));
  CHECK(faulty.comesHome());
  CHECK_FALSE(faulty.hasChanged());
}

TEST_CASE("a robot that falls while it calibrates makes its motors weak and says so", "[robot]") {
  // Proves it for a tilt beyond the limit while pictures are taken, and that the history then has one fall.
  Faulty faulty;
  REQUIRE(faulty.untilPose(2)["phase"] == "collecting");
  faulty.robot.inject([](RobotState& state) { state.torsoAngles.y() = radians(50); });
  const json state = faulty.until([](const json&) { return false; });
  CHECK(state["sentence"] ==
        "The calibration ended. The torso is tilted by 50 degrees, so the motors are weak. Stand the "
        "robot up and start again.");
  CHECK(faulty.playerComesTo("phase", "fallen"));
  CHECK_FALSE(faulty.hasChanged());
  faulty.process->stop();
  faulty.process.reset(); // runs are recorded on a thread of their own
  REQUIRE(faulty.runs().size() == 1);
  CHECK(faulty.runs().front().kind == fallKind);
}

TEST_CASE("a camera that repeats a picture or is covered is waited for, and says what it needs", "[robot]") {
  // Proves both sentences, and that Stop brings the robot to its stand.
  Faulty faulty;
  REQUIRE(faulty.untilPose(1)["phase"] == "collecting");
  faulty.cameras.fault = FaultyCameras::Fault::frozen;
  CHECK_THAT(faulty.untilSaid("takes new pictures"), // after "gives pictures", if a picture was due
             Catch::EndsWith("waits until the top camera takes new pictures: it repeats one, so restart the robot."));
  faulty.cameras.fault = FaultyCameras::Fault::black;
  CHECK_THAT(faulty.untilSaid("black"), Catch::EndsWith("waits until the top camera sees something: its pictures are "
                                                        "black, so uncover it or make light."));
  faulty.process->configuration().set("Brain.CalibrationRunner", "run", "");
  CHECK(faulty.until([](const json&) { return false; })["phase"] == "failed");
  CHECK(faulty.comesHome());
}

TEST_CASE("dead foot sensors and a link that is silent for a second change nothing about a calibration", "[robot]") {
  // Proves it for a whole calibration, and that dead sensors are told with its outcome.
  Faulty faulty;
  faulty.robot.inject([](RobotState& state) { state.forces.fill(0); });
  faulty.debug->send(0, "Brain.calibrationOutcome");
  REQUIRE(faulty.untilPose(2)["phase"] == "collecting");
  faulty.robot.silence(true);
  std::this_thread::sleep_for(std::chrono::seconds{1});
  faulty.robot.silence(false);
  std::string warnings;
  json state = {{"phase", ""}};
  while (state["phase"] != "finished" && state["phase"] != "failed" && state["phase"] != "silent") {
    const auto update = faulty.debug->receive(2);
    for (const json& value : update ? json::parse(update->body) : json{{{"key", ""}}}) {
      if (value["key"] == "Brain.calibration") {
        state = value["value"];
      } else if (value["key"] == "Brain.calibrationOutcome") {
        warnings = value["value"]["warnings"].dump();
      } else if (value["key"] == "") {
        state["phase"] = "silent";
      }
    }
  }
  CHECK(state["phase"] == "finished");
  CHECK_THAT(warnings, Catch::Contains("The foot sensors showed no load in any picture."));
}

} // namespace naocal
