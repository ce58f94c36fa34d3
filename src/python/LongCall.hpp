#pragma once

#include "math/Checkpoints.hpp"

#include <chrono>
#include <cstddef>
#include <optional>
#include <pybind11/pybind11.h>

namespace naocal {

/// A long computation on behalf of Python. While it runs, other threads of Python run too: it does not hold the
/// interpreter's lock (GIL). At its checkpoints (math/Checkpoints.hpp), at most twenty times a second, it handles
/// signals, so that Ctrl-C raises KeyboardInterrupt, and calls `progress(done, total)`. What Python raises there ends
/// it.
class LongCall {
public:
  /// `progress`: a callable, or None. Until `report` was called, `done` is the number of checkpoints, and `total` None.
  explicit LongCall(pybind11::object progress = pybind11::none());

  /// Returns what `compute` returns. Call it with the GIL.
  template <class Compute> auto run(const Compute& compute) {
    const pybind11::gil_scoped_release released;
    const Checkpoints checkpoints{[this] { reachCheckpoint(); }};
    return compute();
  }

  /// Sets the progress and calls `progress`. For the computation, in its thread.
  void report(std::size_t done, std::size_t total);

private:
  using Clock = std::chrono::steady_clock;

  void reachCheckpoint();
  void callPython();

  pybind11::object progress_;
  std::size_t done_ = 0;
  std::optional<std::size_t> total_;
  Clock::time_point due_; // of the next call of Python
};

} // namespace naocal
