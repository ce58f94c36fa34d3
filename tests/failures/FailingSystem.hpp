#pragma once

#include <cstddef>

/// The system's refusals, injected: this test program has its own `operator new` and its own `read`.
namespace naocal::failing {

/// RAII: the `number`-th allocation by `operator new` on this thread fails (1: the next one), and with `onwards` all
/// after it until the end of the scope. One at a time.
class Allocation {
public:
  explicit Allocation(std::size_t number, bool onwards = false);
  ~Allocation();
  Allocation(const Allocation&) = delete;
  Allocation& operator=(const Allocation&) = delete;

  static bool hasFailed(); // whether the scope's allocation was reached
  static void stop();      // from here on, all succeed
};

enum class ReadFailure { error, shortRead, interrupted }; // EIO; one byte; EINTR

/// RAII: the `number`-th call of `read` fails in this way; all others work. One at a time.
class Read {
public:
  Read(std::size_t number, ReadFailure how);
  ~Read();
  Read(const Read&) = delete;
  Read& operator=(const Read&) = delete;

  static bool hasFailed();
};

} // namespace naocal::failing
