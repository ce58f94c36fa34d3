#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

namespace naocal {

/// Keeps a world whose time is not the wall's in step with its camera loop: the motion loop's side waits until the
/// camera loop has taken all pictures and asks for another one. So the same program sees the same every time, and
/// nothing is skipped because a computer is slow. All under one mutex.
class LockStep {
public:
  std::condition_variable changed;

  /// The camera loop's side exists; without one nobody waits.
  void use(bool used) {
    used_ = used;
    changed.notify_all();
  }

  /// Motion's side: until the camera loop has nothing to do but wait. A loop that does nothing for `patience` of wall
  /// time is not waited for until it comes back.
  void waitForCameraLoop(std::unique_lock<std::mutex>& lock, const std::function<bool()>& hasPendingImage) {
    constexpr std::chrono::seconds patience{2};
    const auto idle = [&] { return !used_ || (waits_ && !hasPendingImage()); };
    asleep_ = asleep_ || !changed.wait_for(lock, patience, idle);
  }

  /// The cameras' side: until there is a picture or nothing more will come.
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
