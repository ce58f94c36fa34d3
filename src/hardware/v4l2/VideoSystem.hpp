#pragma once

#include <cstddef>
#include <cstring>
#include <fmt/format.h>
#include <span>
#include <stdexcept>
#include <string>

struct pollfd;

namespace naocal {

/// Why a camera does not deliver, as the end of a sentence. Stays within the driver.
class VideoError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Throws for the negative result of a system call; else hands it on.
inline int checkCall(int result, const char* what) {
  if (result < 0) {
    throw VideoError{fmt::format("{}: {}", what, std::strerror(-result))};
  }
  return result;
}

/// The system calls that capture needs, so that tests can be the kernel. All return what the kernel does, but a failure
/// as the negative error number; calls that a signal interrupts are repeated.
class VideoSystem {
public:
  virtual ~VideoSystem() = default;

  virtual int open(const std::string& path) = 0; // for reading and writing, not blocking
  virtual void close(int file) = 0;
  virtual int ioctl(int file, unsigned long request, void* argument) = 0;
  virtual void* map(std::size_t length, int file, long offset) = 0; // nullptr: failed
  virtual void unmap(void* memory, std::size_t length) = 0;
  virtual int poll(std::span<pollfd> files, int milliseconds) = 0;
};

/// The real one.
VideoSystem& kernelVideoSystem();

} // namespace naocal
