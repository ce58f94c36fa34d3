#pragma once

#include <functional>
#include <utility>

namespace naocal {

/// Lets a program act between the steps of a long computation: `visit` is called at every checkpoint that the thread of
/// this object reaches during its lifetime. An exception of `visit` ends the computation. Without such an object a
/// checkpoint does nothing; checkpoints of other threads are ignored.
class Checkpoints {
public:
  explicit Checkpoints(std::function<void()> visit) : visit_{std::move(visit)}, outer_{current} { current = this; }
  ~Checkpoints() { current = outer_; }
  Checkpoints(const Checkpoints&) = delete;
  Checkpoints& operator=(const Checkpoints&) = delete;

  /// Called by computations between two steps, at most a fraction of a second apart.
  static void reach() {
    if (current != nullptr) {
      current->visit_();
    }
  }

private:
  inline static thread_local Checkpoints* current = nullptr;

  std::function<void()> visit_;
  Checkpoints* outer_;
};

} // namespace naocal
