#include "hardware/simulated/SimulatedWorld.hpp"

#include "hardware/LockStep.hpp"
#include "hardware/RobotInterface.hpp"
#include "hardware/simulated/SimulatedBody.hpp"
#include "hardware/simulated/SimulatedCamera.hpp"
#include "simulation/Simulation.hpp"

#include <algorithm>
#include <deque>
#include <fmt/format.h>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace naocal {
namespace {

constexpr int parts = 4;                // substeps per cycle; motion is linear within one
constexpr std::size_t remembered = 400; // substeps kept: 1.2 s
constexpr int instants = 9;             // camera poses per exposure

/// Quick worlds start at a fixed time, so that runs are reproducible.
TimePoint beginning(const SimulatedPlan& plan) {
  return plan.pace == Pace::quick ? TimePoint{std::chrono::seconds{1000}} : std::chrono::steady_clock::now();
}

std::chrono::nanoseconds half(Seconds duration) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(duration / 2);
}

/// Interpolates two torso poses in the world frame.
Eigen::Isometry3d between(const Eigen::Isometry3d& one, const Eigen::Isometry3d& other, double share) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond{one.linear()}.slerp(share, Eigen::Quaterniond{other.linear()});
  Eigen::Isometry3d result{turn};
  result.translation() = (1 - share) * one.translation() + share * other.translation();
  return result;
}

} // namespace

/// State shared by both interfaces; `mutex` protects all members.
struct SimulatedShared {
  SimulatedShared(const Robot& drawing, const SimulatedPlan& plan);

  struct Moment {
    TimePoint time;
    Eigen::VectorXd joints;
    Eigen::Isometry3d worldFromTorso;
  };
  /// Linear between quarters of cycles; absent outside the last second.
  std::optional<Moment> stateAt(TimePoint time) const;

  bool hasPendingImage() const { return cameras[0].pending || cameras[1].pending; }

  /// Advances one cycle: due commands, body, completed images.
  void advance();

  static constexpr std::chrono::milliseconds cycle{12};

  const SimulatedPlan plan;
  const Robot drawing;
  const SimulatedErrors errors;
  mutable std::mutex mutex;
  LockStep step;
  SimulatedBody body;
  TimePoint now;
  std::deque<std::pair<TimePoint, RobotCommand>> commands; // with the time when they reach the motors
  std::array<SimulatedCamera, 2> cameras;                  // by CameraName
  RobotStatus link;
  Touch touched;

private:
  void remember();
  void expose(std::size_t camera, TimePoint begins);

  std::deque<Moment> history_;
};

SimulatedShared::SimulatedShared(const Robot& robotDrawing, const SimulatedPlan& simulatedPlan)
    : plan{simulatedPlan}, drawing{robotDrawing}, errors{drawErrors(robotDrawing, simulatedPlan)}, body{robotDrawing,
                                                                                                        simulatedPlan,
                                                                                                        errors},
      now{beginning(simulatedPlan)}, cameras{SimulatedCamera{CameraName::top, simulatedPlan, now},
                                             SimulatedCamera{CameraName::bottom, simulatedPlan,
                                                             now + half(simulatedPlan.cameras.period)}} {
  remember();
}

void SimulatedShared::remember() {
  history_.push_back({now, body.trueAngles(), body.worldFromTorso()});
  if (history_.size() > remembered) {
    history_.pop_front();
  }
}

std::optional<SimulatedShared::Moment> SimulatedShared::stateAt(TimePoint time) const {
  if (time < history_.front().time || time > history_.back().time) {
    return std::nullopt;
  }
  const auto after = std::lower_bound(history_.begin() + (history_.size() > 1), history_.end(), time,
                                      [](const Moment& moment, TimePoint when) { return moment.time < when; });
  const Moment& other = *after;
  const Moment& one = history_.size() > 1 ? *(after - 1) : other;
  const double share = time == one.time ? 0 : Seconds{time - one.time} / Seconds{other.time - one.time};
  return Moment{time, one.joints + share * (other.joints - one.joints),
                between(one.worldFromTorso, other.worldFromTorso, share)};
}

void SimulatedShared::advance() {
  for (int part = 0; part < parts; ++part) {
    while (!commands.empty() && commands.front().first <= now) {
      body.command(commands.front().second);
      commands.pop_front();
    }
    body.advance(cycle / parts);
    now += cycle / parts;
    remember();
  }
  for (std::size_t camera = 0; camera < cameras.size(); ++camera) {
    while (const auto begins = cameras[camera].nextArrival(now)) {
      expose(camera, *begins);
    }
  }
}

void SimulatedShared::expose(std::size_t camera, TimePoint begins) {
  std::vector<Eigen::Isometry3d> worldFromCamera;
  const std::size_t mount = drawing.cameraIndex(toString(CameraName(camera))).value();
  for (int instant = 0; instant < instants; ++instant) {
    const TimePoint time = begins + cameras[camera].span() * instant / (instants - 1);
    const Moment moment = stateAt(std::clamp(time, history_.front().time, history_.back().time)).value();
    worldFromCamera.push_back(body.worldFromCamera(mount, moment.joints, moment.worldFromTorso));
  }
  cameras[camera].deliver(worldFromCamera);
}

namespace {

/// Interface for the camera loop.
class SimulatedCameras : public CameraInterface {
public:
  explicit SimulatedCameras(std::shared_ptr<SimulatedShared> shared) : shared_{std::move(shared)} {
    const std::lock_guard lock{shared_->mutex};
    shared_->step.use(true);
  }
  ~SimulatedCameras() override {
    const std::lock_guard lock{shared_->mutex};
    shared_->step.use(false);
  }

  std::optional<CameraFrame> waitForFrame(std::chrono::milliseconds timeout) override {
    std::unique_lock lock{shared_->mutex};
    SimulatedCamera& top = shared_->cameras[0];
    SimulatedCamera& bottom = shared_->cameras[1];
    shared_->step.waitForImage(lock, timeout, [this] { return shared_->hasPendingImage(); });
    if (!top.pending && !bottom.pending) {
      return std::nullopt;
    }
    SimulatedCamera& older =
        !bottom.pending || (top.pending && top.pending->time <= bottom.pending->time) ? top : bottom;
    ++older.link.frames;
    return std::exchange(older.pending, std::nullopt);
  }

  CameraStatus status(CameraName camera) const override {
    const std::lock_guard lock{shared_->mutex};
    const SimulatedCamera& one = shared_->cameras[std::size_t(camera)];
    CameraStatus link = one.link;
    link.problem = one.blocked ? fmt::format("the {} camera gives no pictures", toString(camera)) : "";
    return link;
  }

private:
  std::shared_ptr<SimulatedShared> shared_;
};

/// Interface for the motion loop; each state advances one cycle.
class SimulatedRobot : public RobotInterface {
public:
  explicit SimulatedRobot(std::shared_ptr<SimulatedShared> shared) : shared_{std::move(shared)} {}

  std::optional<RobotIdentity> waitForIdentity(std::chrono::milliseconds) override {
    const std::string id = fmt::format("{}{}", syntheticIdPrefix, shared_->plan.seed);
    return RobotIdentity{id, id, shared_->drawing.model, shared_->drawing.model};
  }

  std::optional<RobotState> waitForState(std::chrono::milliseconds timeout) override {
    std::unique_lock lock{shared_->mutex};
    if (shared_->plan.pace == Pace::quick) {
      shared_->step.waitForCameraLoop(lock, [this] { return shared_->hasPendingImage(); });
    } else {
      const TimePoint wake =
          std::min(shared_->now + SimulatedShared::cycle, std::chrono::steady_clock::now() + timeout);
      lock.unlock();
      std::this_thread::sleep_until(wake);
      lock.lock();
      if (wake < shared_->now + SimulatedShared::cycle) {
        return std::nullopt;
      }
      catchUp();
    }
    shared_->advance();
    ++shared_->link.states;
    RobotState state;
    shared_->body.measure(state);
    state.time = shared_->now;
    state.touch = shared_->touched;
    state.battery = {0.9, 0, -1.5, 30};
    shared_->step.changed.notify_all();
    return state;
  }

  void send(const RobotCommand& command) override {
    const std::lock_guard lock{shared_->mutex};
    const auto delay = std::chrono::duration_cast<std::chrono::nanoseconds>(shared_->plan.commandDelay);
    shared_->commands.emplace_back(shared_->now + delay, command);
  }

  std::chrono::nanoseconds period() const override { return SimulatedShared::cycle; }
  RobotStatus status() const override {
    const std::lock_guard lock{shared_->mutex};
    return shared_->link;
  }

private:
  /// Advances the world past cycles that a late program missed; their states are lost.
  void catchUp() {
    constexpr int most = 100; // cycles; after a longer stop only the time advances
    for (int missed = 0; shared_->now + 2 * SimulatedShared::cycle <= std::chrono::steady_clock::now(); ++missed) {
      if (missed < most) {
        shared_->advance();
        ++shared_->link.lostStates;
      } else {
        shared_->now += SimulatedShared::cycle;
      }
    }
  }

  std::shared_ptr<SimulatedShared> shared_;
};

} // namespace

SimulatedWorld::SimulatedWorld(const Robot& drawing, const SimulatedPlan& plan)
    : shared_{std::make_shared<SimulatedShared>(drawing, plan)} {}

SimulatedWorld::~SimulatedWorld() = default;

std::unique_ptr<RobotInterface> SimulatedWorld::robot() {
  return std::make_unique<SimulatedRobot>(shared_);
}

std::unique_ptr<CameraInterface> SimulatedWorld::cameras() {
  return std::make_unique<SimulatedCameras>(shared_);
}

const SimulatedErrors& SimulatedWorld::errors() const {
  return shared_->errors;
}

SimulatedWorld::Truth SimulatedWorld::truth() const {
  const std::lock_guard lock{shared_->mutex};
  const SimulatedBody& body = shared_->body;
  return {shared_->now, body.trueAngles(), body.worldFromTorso(), body.supportFoot(), body.hasFallen()};
}

std::optional<Eigen::VectorXd> SimulatedWorld::jointsAt(TimePoint time) const {
  const std::lock_guard lock{shared_->mutex};
  const auto moment = shared_->stateAt(time);
  return moment ? std::optional{moment->joints} : std::nullopt;
}

void SimulatedWorld::touch(const Touch& touch) {
  const std::lock_guard lock{shared_->mutex};
  shared_->touched = touch;
}

void SimulatedWorld::block(CameraName camera, bool blocked) {
  const std::lock_guard lock{shared_->mutex};
  shared_->cameras[std::size_t(camera)].blocked = blocked;
}

} // namespace naocal
