#include "hardware/replay/ReplayWorld.hpp"

#include "data/CaptureSetFile.hpp"
#include "hardware/LockStep.hpp"
#include "hardware/replay/ReplayTimeline.hpp"

#include <deque>
#include <thread>

namespace naocal {

/// State shared by both interfaces; `mutex` protects all mutable members.
struct ReplayShared {
  ReplayShared(const std::filesystem::path& folder, const ReplayOptions& replayOptions)
      : options{replayOptions}, set{readCaptureSet(folder).set}, timeline{buildTimeline(set, folder,
                                                                                        replayOptions.latency)} {}

  bool over() const { return nextMoment == timeline.moments.size(); }

  const ReplayOptions options;
  const CaptureSet set;
  const ReplayTimeline timeline;
  std::mutex mutex;
  LockStep step;
  std::size_t nextMoment = 0, nextPicture = 0; // next ones to return; images before `arrived` are available
  std::size_t arrived = 0;
  std::optional<TimePoint> began; // wall time of the first state
  RobotStatus link;
  std::array<CameraStatus, 2> cameraLinks;
};

namespace {

constexpr std::chrono::milliseconds pause{10}; // limits the polling rate after the end

class ReplayedRobot : public RobotInterface {
public:
  explicit ReplayedRobot(std::shared_ptr<ReplayShared> shared) : shared_{std::move(shared)} {}

  std::optional<RobotIdentity> waitForIdentity(std::chrono::milliseconds) override {
    const CaptureSet& set = shared_->set;
    return RobotIdentity{set.bodyId, set.headId, set.model, set.model};
  }

  std::optional<RobotState> waitForState(std::chrono::milliseconds timeout) override {
    std::unique_lock lock{shared_->mutex};
    ReplayShared& shared = *shared_;
    shared.step.waitForCameraLoop(lock, [&] { return shared.nextPicture < shared.arrived; });
    if (shared.over()) {
      lock.unlock();
      std::this_thread::sleep_for(std::min(timeout, pause));
      return std::nullopt;
    }
    const ReplayTimeline::Moment moment = shared.timeline.moments[shared.nextMoment];
    if (shared.options.realPace && !waitUntil(moment.time, timeout, lock)) {
      return std::nullopt;
    }
    ++shared.nextMoment;
    ++shared.link.states;
    const auto& pictures = shared.timeline.pictures;
    while (shared.arrived < pictures.size() && (pictures[shared.arrived].arrives <= moment.time || shared.over())) {
      ++shared.arrived;
    }
    shared.step.changed.notify_all();
    return stateAtCapture(shared.set, shared.set.captures[moment.capture], moment.time);
  }

  void send(const RobotCommand&) override {}
  std::chrono::nanoseconds period() const override { return std::chrono::milliseconds{12}; }
  bool hasEnded() const override {
    const std::lock_guard lock{shared_->mutex};
    return shared_->over();
  }
  RobotStatus status() const override {
    const std::lock_guard lock{shared_->mutex};
    return shared_->link;
  }

private:
  bool waitUntil(TimePoint time, std::chrono::milliseconds timeout, std::unique_lock<std::mutex>& lock) {
    const TimePoint now = Clock::now();
    shared_->began = shared_->began.value_or(now);
    const TimePoint due = *shared_->began + (time - shared_->timeline.moments.front().time);
    lock.unlock();
    std::this_thread::sleep_until(std::min(due, now + timeout));
    lock.lock();
    return due <= now + timeout;
  }

  std::shared_ptr<ReplayShared> shared_;
};

class ReplayedCameras : public CameraInterface {
public:
  explicit ReplayedCameras(std::shared_ptr<ReplayShared> shared) : shared_{std::move(shared)} {
    const std::lock_guard lock{shared_->mutex};
    shared_->step.use(true);
  }
  ~ReplayedCameras() override {
    const std::lock_guard lock{shared_->mutex};
    shared_->step.use(false);
  }

  std::optional<CameraFrame> waitForFrame(std::chrono::milliseconds timeout) override {
    std::unique_lock lock{shared_->mutex};
    ReplayShared& shared = *shared_;
    shared.step.waitForImage(lock, timeout, [&] { return shared.nextPicture < shared.arrived; });
    if (shared.nextPicture == shared.arrived) {
      return std::nullopt;
    }
    const CameraFrame& frame = shared.timeline.pictures[shared.nextPicture++].frame;
    ++shared.cameraLinks[std::size_t(frame.camera)].frames;
    if (shared.nextPicture == shared.timeline.pictures.size()) {
      shared.step.use(false); // no images left: stop waiting for this loop
    }
    return frame;
  }

  bool hasEnded() const override {
    const std::lock_guard lock{shared_->mutex};
    return shared_->nextPicture == shared_->timeline.pictures.size();
  }
  CameraStatus status(CameraName camera) const override {
    const std::lock_guard lock{shared_->mutex};
    return shared_->cameraLinks[std::size_t(camera)];
  }

private:
  std::shared_ptr<ReplayShared> shared_;
};

} // namespace

ReplayWorld::ReplayWorld(const std::filesystem::path& folder, const ReplayOptions& options)
    : shared_{std::make_shared<ReplayShared>(folder, options)} {}

std::unique_ptr<RobotInterface> ReplayWorld::robot() {
  return std::make_unique<ReplayedRobot>(shared_);
}

std::unique_ptr<CameraInterface> ReplayWorld::cameras() {
  return std::make_unique<ReplayedCameras>(shared_);
}

const CaptureSet& ReplayWorld::set() const {
  return shared_->set;
}

const Capture* ReplayWorld::captureOf(const CameraFrame& frame) const {
  for (const ReplayTimeline::Picture& picture : shared_->timeline.pictures) {
    if (picture.frame.camera == frame.camera && picture.frame.sequence == frame.sequence) {
      return &shared_->set.captures[picture.capture];
    }
  }
  return nullptr;
}

} // namespace naocal
