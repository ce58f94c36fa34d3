#include "hardware/v4l2/VideoSystem.hpp"

#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace naocal {
namespace {

template <typename Call> int repeated(const Call& call) {
  int result;
  do {
    result = call();
  } while (result < 0 && errno == EINTR);
  return result < 0 ? -errno : result;
}

class KernelVideo : public VideoSystem {
public:
  int open(const std::string& path) override {
    return repeated([&] { return ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC); });
  }
  void close(int file) override { ::close(file); }
  int ioctl(int file, unsigned long request, void* argument) override {
    return repeated([&] { return ::ioctl(file, request, argument); });
  }
  void* map(std::size_t length, int file, long offset) override {
    void* const memory = mmap(nullptr, length, PROT_READ | PROT_WRITE, MAP_SHARED, file, offset);
    return memory == MAP_FAILED ? nullptr : memory;
  }
  void unmap(void* memory, std::size_t length) override { munmap(memory, length); }
  int poll(std::span<pollfd> files, int milliseconds) override {
    return repeated([&] { return ::poll(files.data(), files.size(), milliseconds); });
  }
};

} // namespace

VideoSystem& kernelVideoSystem() {
  static KernelVideo kernel;
  return kernel;
}

} // namespace naocal
