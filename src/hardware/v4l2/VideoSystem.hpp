#pragma once

#include <cstddef>
#include <cstring>
#include <fmt/format.h>
#include <span>
#include <stdexcept>
#include <string>

struct pollfd;

namespace naocal {

/// A camera failure, as the end of a sentence. Never leaves the V4L2 driver code.
class VideoError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Throws VideoError for a negative result of a system call; otherwise returns it.
inline int checkCall(int result, const char* what) {
  if (result < 0) {
    throw VideoError{fmt::format("{}: {}", what, std::strerror(-result))};
  }
  return result;
}

/// System calls used for capture, replaceable in tests. They return the kernel's result, or the negative error number
/// on failure; calls interrupted by a signal are repeated.
class VideoSystem {
public:
  virtual ~VideoSystem() = default;

  virtual int open(const std::string& path) = 0; // read-write, non-blocking
  virtual void close(int file) = 0;
  virtual int ioctl(int file, unsigned long request, void* argument) = 0;
  virtual void* map(std::size_t length, int file, long offset) = 0; // nullptr on failure
  virtual void unmap(void* memory, std::size_t length) = 0;
  virtual int poll(std::span<pollfd> files, int milliseconds) = 0;
};

/// The kernel's system calls.
VideoSystem& kernelVideoSystem();

} // namespace naocal
