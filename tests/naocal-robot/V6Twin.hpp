#pragma once

#include "DrivenProcess.hpp"
#include "Hardware.hpp"
#include "hardware/nao/LolaTwin.hpp"
#include "hardware/v4l2/FakeVideo.hpp"

#include "framework/core/Thread.hpp"
#include "hardware/nao/DeviceConventions.hpp"
#include "hardware/nao/LolaRobot.hpp"
#include "hardware/simulated/SimulatedWorld.hpp"
#include "hardware/v4l2/VideoCameras.hpp"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace naocal {

/// Timeout of a twin with simulated time: it then continues without the program.
inline constexpr std::chrono::seconds twinPatience{2};

/// A thread-safe kernel: one thread exposes pictures, another reads the cameras.
class SharedVideo : public VideoSystem {
  template <typename Call> auto guarded(const Call& call) {
    const std::lock_guard lock{mutex_};
    return call();
  }

public:
  void expose(const CameraFrame& frame) {
    const auto bytes = frame.picture->bytes(); // rendered before locking, so that the brain's thread is not blocked
    const std::lock_guard lock{mutex_};
    const char* path = frame.camera == CameraName::top ? "/dev/video-top" : "/dev/video-bottom";
    video_.expose(video_.cameras[path], bytes, frame.time.time_since_epoch());
    idle_ = false;
  }
  /// Waits until the cameras' thread has taken all pictures and waits for the next one.
  void waitForReader() {
    std::unique_lock lock{mutex_};
    changed_.wait_for(lock, twinPatience, [this] { return idle_; });
  }
  int open(const std::string& path) override {
    return guarded([&] { return video_.open(path); });
  }
  void close(int file) override {
    guarded([&] {
      video_.close(file);
      return 0;
    });
  }
  int ioctl(int file, unsigned long request, void* argument) override {
    return guarded([&] { return video_.ioctl(file, request, argument); });
  }
  void* map(std::size_t length, int file, long offset) override {
    return guarded([&] { return video_.map(length, file, offset); });
  }
  void unmap(void* memory, std::size_t length) override {
    guarded([&] {
      video_.unmap(memory, length);
      return 0;
    });
  }
  int poll(std::span<pollfd> files, int milliseconds) override {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds{milliseconds};
    int ready = 0;
    const auto poll = [&] {
      ready = video_.poll(files, 0);
      idle_ = ready == 0;
      return ready;
    };
    while (guarded(poll) == 0 && std::chrono::steady_clock::now() < deadline) {
      changed_.notify_all();
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    return ready;
  }

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool idle_ = true;
  FakeVideo video_;
};

/// A V6 as seen by programs on its head: LoLA's socket and two V4L2 cameras, connected to a simulated robot. With
/// `Pace::quick` its time is simulated: it waits for every command and until every picture was taken.
class V6Twin {
public:
  V6Twin(const Robot& drawing, SimulatedPlan plan, const std::filesystem::path& socket)
      : world{drawing, plan}, isQuick_{plan.pace == Pace::quick}, lola_{socket}, body_{world.robot()},
        eyes_{world.cameras()} {
    motion_ = std::jthread{[this](const std::stop_token& stop) { live(stop); }};
    sight_ = std::jthread{[this](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        if (const auto frame = eyes_->waitForFrame(std::chrono::milliseconds{50})) {
          video.expose(*frame);
          if (isQuick_) {
            video.waitForReader();
          }
        }
      }
    }};
  }

  ~V6Twin() {
    motion_.request_stop();
    lola_.stopListening();
  }

  SimulatedWorld world;
  SharedVideo video;
  std::atomic<int> states = 0, commands = 0; // sent; received
  std::atomic<TimePoint> due{};              // when the last state was sent
  std::atomic<TimePoint> stateTime{};        // robot's time of the last state

private:
  void live(const std::stop_token& stop) {
    requestRealTimePriority(40); // like the firmware, if permitted
    lola_.accept();
    RobotCommand command;
    command.angles = SimulatedPlan::standingAngles();
    command.stiffness.fill(0.8);
    while (!stop.stop_requested()) {
      const auto state = body_->waitForState(std::chrono::seconds{1});
      due = Clock::now();
      if (!state) {
        continue;
      }
      stateTime = state->time;
      if (!lola_.send(twin::stateOf([&](std::string_view list, std::size_t i) { return number(*state, list, i); }))) {
        lola_.accept(); // the program was restarted
        continue;
      }
      ++states;
      constexpr std::chrono::milliseconds cycleShare{8}; // of a 12 ms cycle; the robot continues without a reply
      const std::chrono::milliseconds patience = isQuick_ ? twinPatience : cycleShare;
      const std::string message = lola_.hears(int(patience.count())) ? lola_.receive(lolaCommandSize) : "";
      if (message.size() == lolaCommandSize) {
        for (std::size_t i = 0; i < twin::names.size(); ++i) {
          const std::size_t joint = *jointIndex(twin::names[i]);
          command.angles[joint] = twin::commanded(message, "Position", i);
          command.stiffness[joint] = std::max(0.f, twin::commanded(message, "Stiffness", i));
        }
        for (std::size_t i = 0; i < command.leds.leftEye.size(); ++i) { // all red values, then green, then blue
          command.leds.leftEye[i] = {twin::commanded(message, "LEye", i), twin::commanded(message, "LEye", i + 8),
                                     twin::commanded(message, "LEye", i + 16)};
        }
        body_->send(command);
        ++commands;
      }
    }
  }

  static double number(const RobotState& state, std::string_view list, std::size_t i) {
    const auto joint = [&](const auto& values) { return double(values[*jointIndex(twin::names[i])]); };
    const auto place = Eigen::Index(i);
    return list == "Position"        ? joint(state.angles.values)
           : list == "Stiffness"     ? joint(state.stiffness)
           : list == "Current"       ? joint(state.current)
           : list == "Temperature"   ? joint(state.temperature)
           : list == "Accelerometer" ? state.accelerometer[place]
           : list == "Gyroscope"     ? state.gyroscope[place]
           : list == "Angles"        ? state.torsoAngles[place]
           : list == "FSR"           ? state.forces[i]
           : list == "Touch"         ? double(state.touch.*touchOrder[i])
           : list == "Battery"       ? std::array{0.9, 0., -1.5, 30.}[i]
                                     : 0;
  }

  bool isQuick_;
  twin::Server lola_;
  std::unique_ptr<RobotInterface> body_;
  std::unique_ptr<CameraInterface> eyes_;
  std::jthread motion_, sight_;
};

/// Replaces the arrival time of states by the twin's time.
class TwinTimedRobot : public RobotInterface {
public:
  TwinTimedRobot(RobotInterface& robot, const V6Twin& twin) : robot_{robot}, twin_{twin} {}

  std::optional<RobotIdentity> waitForIdentity(std::chrono::milliseconds timeout) override {
    return robot_.waitForIdentity(timeout);
  }
  std::optional<RobotState> waitForState(std::chrono::milliseconds timeout) override {
    auto state = robot_.waitForState(timeout);
    if (state) {
      state->time = twin_.stateTime; // the next state is sent only after the reply to this one
    }
    return state;
  }
  void send(const RobotCommand& command) override { robot_.send(command); }
  std::chrono::nanoseconds period() const override { return robot_.period(); }
  RobotStatus status() const override { return robot_.status(); }

private:
  RobotInterface& robot_;
  const V6Twin& twin_;
};

/// The process as on a V6's head.
struct V6Process : DrivenProcess {
  using Watch = std::function<std::unique_ptr<RobotInterface>(RobotInterface&, V6Twin&)>;

  /// `watch`: wraps the robot interface.
  explicit V6Process(const SimulatedPlan& plan, const Watch& watch = {})
      : twin{drawing, plan, folder.path() / "robocup"}, robot{folder.path() / "robocup"}, cameras{videoOptionsForModel(
                                                                                                      "V6"),
                                                                                                  twin.video} {
    const bool isQuick = plan.pace == Pace::quick;
    watched = watch     ? watch(robot, twin)
              : isQuick ? std::make_unique<TwinTimedRobot>(robot, twin)
                        : std::unique_ptr<RobotInterface>{};
    begin(
        watched ? *watched : robot, cameras, drawing,
        [this, isQuick] { return isQuick ? twin.world.truth().time : Clock::now(); }, bool(watch));
  }
  ~V6Process() { process.reset(); }

  Robot drawing = loadRobot(configurationDirectory(), "V6");
  V6Twin twin;
  LolaRobot robot;
  VideoCameras cameras;
  std::unique_ptr<RobotInterface> watched; // if set by `watch`, real-time priority is requested too
};

} // namespace naocal
