#pragma once

#include <cstddef>
#include <span>
#include <string>

struct pollfd;

namespace naocal {

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
VideoSystem& kernelVideo();

} // namespace naocal
