#include "Flood.hpp"
#include "SimulatedProcess.hpp"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fmt/format.h>
#include <map>
#include <mutex>
#include <utility>

namespace naocal {

using nlohmann::json;

namespace {

/// Times between consecutive wake-ups of a thread [s]. Thread-safe.
class Periods {
public:
  void note() {
    const TimePoint now = Clock::now();
    const std::lock_guard lock{mutex_};
    if (last_ != TimePoint{}) {
      all_.push_back(toSeconds(now - last_));
    }
    last_ = now;
  }
  /// The periods since the last call, sorted; at least one.
  std::vector<double> take() {
    const std::lock_guard lock{mutex_};
    std::vector<double> taken = std::exchange(all_, {});
    taken.push_back(0);
    std::sort(taken.begin(), taken.end());
    return taken;
  }

private:
  std::mutex mutex_;
  TimePoint last_;
  std::vector<double> all_;
};

double quantile(const std::vector<double>& sorted, double share) {
  return sorted[std::size_t(share * double(sorted.size() - 1))];
}

/// A simulated robot at the wall's pace, which notes when the motion thread gets its states.
class NotedRobot : public RobotInterface {
public:
  explicit NotedRobot(std::unique_ptr<RobotInterface> robot) : robot_{std::move(robot)} {}
  std::optional<RobotIdentity> waitForIdentity(std::chrono::milliseconds timeout) override {
    return robot_->waitForIdentity(timeout);
  }
  std::optional<RobotState> waitForState(std::chrono::milliseconds timeout) override {
    auto state = robot_->waitForState(timeout);
    periods.note();
    stateAt_ = Clock::now();
    return state;
  }
  void send(const RobotCommand& command) override {
    robot_->send(command);
    longestWork = std::max(longestWork.load(), toSeconds(Clock::now() - stateAt_));
  }
  std::chrono::nanoseconds period() const override { return robot_->period(); }
  RobotStatus status() const override { return robot_->status(); }

  Periods periods;
  std::atomic<double> longestWork = 0; // from a state to its answer [s]

private:
  std::unique_ptr<RobotInterface> robot_;
  TimePoint stateAt_; // of the motion thread
};

/// The process on that robot, an idle thread of motion's period and priority, and an operator.
struct Flooded : DrivenProcess {
  Flooded() : world{drawing, plan()}, robot{world.robot()}, cameras{world.cameras()} {
    begin(
        robot, *cameras, drawing, [this] { return world.truth().time; }, true);
    debug.emplace(MateClient::debug(process->sockets().debugPort()));
    debug->send(0, "Brain.calibration");
    debug->send(3);
    debug->receive(4);
    process->start([](std::string_view) {});
    idleThread = std::jthread{[this](const std::stop_token& stop) {
      requestRealTimePriority(30);
      for (TimePoint due = Clock::now(); !stop.stop_requested();) {
        due = std::max(due + std::chrono::milliseconds{12}, Clock::now() - std::chrono::milliseconds{12});
        std::this_thread::sleep_until(due);
        idle.note();
      }
    }};
  }
  ~Flooded() { process.reset(); }

  static SimulatedPlan plan() {
    SimulatedPlan plan = simulatedPlan(1);
    plan.offsetRange = 0;
    return plan;
  }
  void set(const char* key, const json& value) {
    auto config = MateClient::config(process->sockets().configPort());
    config.send(0, json::array({{{"mp", "Brain.CalibrationRunner"}, {"key", key}, {"value", value}}}).dump());
    config.send(1);
    config.receive(5); // was set
  }
  /// Waits for a calibration's phase; false if it does not come within a minute of states.
  bool until(const std::string& phase) {
    constexpr int most = 60 * 30;
    for (int i = 0; i < most; ++i) {
      const auto update = debug->receive(2);
      if (!update || json::parse(update->body).at(0)["value"]["phase"] == phase) {
        return update.has_value();
      }
    }
    return false;
  }

  Robot drawing = loadRobot(configurationDirectory(), "V6");
  SimulatedWorld world;
  NotedRobot robot;
  std::unique_ptr<CameraInterface> cameras;
  std::optional<MateClient> debug;
  Periods idle;
  std::jthread idleThread; // last
};

/// Periods of the motion thread and of the idle one during a flood ("": none), sorted.
struct Measured {
  std::vector<double> motion, idle;
  double work = 0; // longest, from a state to its answer [s]
  double stop = 0; // from a new connection to the end of the calibration that it stops [s]
};

Measured measure(Flooded& flooded, const std::string& kind, int milliseconds) {
  std::optional<FloodProcess> flood;
  if (!kind.empty()) {
    const SocketServers& sockets = flooded.process->sockets();
    flood.emplace(FloodPlan{kind, sockets.debugPort(), sockets.configPort(), milliseconds + 5000});
    std::this_thread::sleep_for(std::chrono::milliseconds{200});
  }
  flooded.robot.periods.take();
  flooded.idle.take();
  flooded.robot.longestWork = 0;
  std::this_thread::sleep_for(std::chrono::milliseconds{milliseconds});
  Measured measured{flooded.robot.periods.take(), flooded.idle.take(), flooded.robot.longestWork};
  flooded.set("run", "head");
  REQUIRE(flooded.until("going home"));
  const TimePoint begin = Clock::now();
  flooded.set("run", "");
  CHECK(flooded.until("failed"));
  measured.stop = toSeconds(Clock::now() - begin);
  return measured;
}

} // namespace

// Child process of the next tests.
TEST_CASE("floods a robot", "[.flood]") {
  Flood flood{FloodProcess::plan()};
  const std::size_t connections = flood.run();
  fmt::print("{} connections\n", connections);
}

TEST_CASE("a flood of strangers neither delays motion nor keeps Stop out", "[robot]") {
  // Proves it for five floods by the middle of the motion thread's periods, which may exceed an idle thread's in the
  // same time by 1 ms, and for nine of ten, by a period: this test may share its machine. A new connection stops a
  // calibration during each flood. The longest periods are measured below.
  Flooded flooded;
  for (const std::string& kind : floodKinds) {
    CAPTURE(kind);
    const Measured measured = measure(flooded, kind, 400);
    CHECK(quantile(measured.motion, 0.5) < quantile(measured.idle, 0.5) + 0.001);
    CHECK(quantile(measured.motion, 0.9) < quantile(measured.idle, 0.9) + 0.012);
  }
}

// Measurement; proves nothing. Environment: SECONDS_EACH, ROUNDS. Run it as root and as an ordinary user: each round
// compares all floods, as the machine may have other work.
TEST_CASE("how late motion gets under floods of strangers", "[.measure]") {
  const auto number = [](const char* name, int usual) {
    const char* given = std::getenv(name);
    return given != nullptr ? std::atoi(given) : usual;
  };
  const int milliseconds = 1000 * number("SECONDS_EACH", 2), rounds = number("ROUNDS", 5);
  Flooded flooded;
  std::vector<std::string> kinds{""};
  kinds.insert(kinds.end(), floodKinds.begin(), floodKinds.end());
  std::map<std::string, std::vector<double>> motion, idle, excess, work, stop; // longest of each round [s]
  for (int round = 0; round < rounds; ++round) {
    for (const std::string& kind : kinds) {
      const Measured one = measure(flooded, kind, milliseconds);
      motion[kind].push_back(one.motion.back());
      idle[kind].push_back(one.idle.back());
      excess[kind].push_back(one.motion.back() - one.idle.back());
      work[kind].push_back(one.work);
      stop[kind].push_back(one.stop);
    }
  }
  fmt::print("user {}, {} rounds of {} ms: the longest period of the motion thread and of an idle thread, median and "
             "largest of the rounds [ms]; median of their differences; largest time from a state to its answer; Stop, "
             "largest\n",
             ::geteuid(), rounds, milliseconds);
  const auto in = [](std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return 1e3 * quantile(values, share);
  };
  for (const std::string& kind : kinds) {
    fmt::print("{:<10} motion {:>7.3f} {:>7.3f}   idle {:>7.3f} {:>7.3f}   difference {:>+7.3f}   answer {:>6.3f}   "
               "Stop {:>5.0f}\n",
               kind.empty() ? "no flood" : kind, in(motion[kind], 0.5), in(motion[kind], 1), in(idle[kind], 0.5),
               in(idle[kind], 1), in(excess[kind], 0.5), in(work[kind], 1), in(stop[kind], 1));
  }
  fmt::print("{}", flooded.log);
}

} // namespace naocal
