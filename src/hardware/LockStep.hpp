#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

namespace naocal {

/// Synchronizes a world with simulated time and its camera loop: the motion side waits until the camera loop has taken
/// all images and waits for the next one. Results are therefore reproducible, and no image is skipped on a slow
/// computer. The caller's mutex protects all members.
class LockStep {
public:
  std::condition_variable changed;

  /// Enables or disables waiting: true while a camera loop exists.
  void use(bool used) {
    used_ = used;
    changed.notify_all();
  }

  /// Motion side: waits until the camera loop is idle and no image is pending. A camera loop that does not return
  /// within `patience` (wall time) is ignored until it waits again.
  void waitForCameraLoop(std::unique_lock<std::mutex>& lock, const std::function<bool()>& hasPendingImage) {
    constexpr std::chrono::seconds patience{2};
    const auto idle = [&] { return !used_ || (waits_ && !hasPendingImage()); };
    asleep_ = asleep_ || !changed.wait_for(lock, patience, idle);
  }

  /// Camera side: waits until `over` is true, or `timeout`.
  void waitForImage(std::unique_lock<std::mutex>& lock, std::chrono::milliseconds timeout,
                    const std::function<bool()>& over) {
    waits_ = true;
    asleep_ = false;
    changed.notify_all();
    changed.wait_for(lock, timeout, over);
    waits_ = false;
  }

private:
  bool used_ = false, waits_ = false, asleep_ = false;
};

} // namespace naocal
