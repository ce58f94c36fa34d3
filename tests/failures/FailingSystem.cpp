#include "failures/FailingSystem.hpp"

#include <cerrno>
#include <cstdlib>
#include <new>
#include <sys/syscall.h>
#include <unistd.h>

namespace naocal::failing {
namespace {

struct Countdown {
  std::size_t left = 0; // calls until the failure; 0: none is planned
  bool onwards = false, failed = false;

  /// Whether this call fails.
  bool count() {
    if (left == 0) {
      return onwards && failed;
    }
    failed = --left == 0;
    return failed;
  }
};

thread_local Countdown allocation;
thread_local Countdown reading;
thread_local ReadFailure readFailure = ReadFailure::error;

void* allocate(std::size_t size, std::size_t alignment) {
  if (allocation.count()) {
    return nullptr;
  }
  const std::size_t whole = size == 0 ? 1 : size;
  return alignment <= alignof(std::max_align_t)
             ? std::malloc(whole)
             : std::aligned_alloc(alignment, (whole + alignment - 1) / alignment * alignment);
}

void* allocateOrThrow(std::size_t size, std::size_t alignment) {
  if (void* const memory = allocate(size, alignment)) {
    return memory;
  }
  throw std::bad_alloc{};
}

} // namespace

Allocation::Allocation(std::size_t number, bool onwards) {
  allocation = {number, onwards, false};
}
Allocation::~Allocation() {
  stop();
}
bool Allocation::hasFailed() {
  return allocation.failed;
}
void Allocation::stop() {
  allocation.left = 0;
  allocation.onwards = false;
}

Read::Read(std::size_t number, ReadFailure how) {
  reading = {number, false, false};
  readFailure = how;
}
Read::~Read() {
  reading.left = 0;
}
bool Read::hasFailed() {
  return reading.failed;
}

} // namespace naocal::failing

using naocal::failing::allocateOrThrow;

extern "C" ssize_t read(int file, void* bytes, std::size_t count) {
  using naocal::failing::ReadFailure;
  if (naocal::failing::reading.count()) {
    if (naocal::failing::readFailure != ReadFailure::shortRead) {
      errno = naocal::failing::readFailure == ReadFailure::error ? EIO : EINTR;
      return -1;
    }
    count = count > 1 ? 1 : count;
  }
  return ::syscall(SYS_read, file, bytes, count);
}

void* operator new(std::size_t size) {
  return allocateOrThrow(size, 1);
}
void* operator new[](std::size_t size) {
  return allocateOrThrow(size, 1);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocateOrThrow(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return allocateOrThrow(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return naocal::failing::allocate(size, 1);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return naocal::failing::allocate(size, 1);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
