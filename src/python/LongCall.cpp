#include "python/LongCall.hpp"

#include <pybind11/stl.h>
#include <utility>

namespace naocal {

namespace py = pybind11;

LongCall::LongCall(py::object progress) : progress_{std::move(progress)}, due_{Clock::now()} {
  if (!progress_.is_none() && PyCallable_Check(progress_.ptr()) == 0) {
    throw py::type_error{"progress: expected a function of (done, total) or None"};
  }
}

void LongCall::report(std::size_t done, std::size_t total) {
  done_ = done;
  total_ = total;
  callPython();
}

void LongCall::reachCheckpoint() {
  done_ += total_ ? 0 : 1;
  if (Clock::now() >= due_) {
    callPython();
  }
}

void LongCall::callPython() {
  const py::gil_scoped_acquire acquired;
  if (PyErr_CheckSignals() != 0) {
    throw py::error_already_set{};
  }
  if (!progress_.is_none()) {
    progress_(done_, total_);
  }
  due_ = Clock::now() + std::chrono::milliseconds{50};
}

} // namespace naocal
