#pragma once

/* Block of POSIX shared memory between NAOqi and naocal on a V5. Plain C++98 with the compiler's atomics (GCC 4.7 and
 * later), because NAOqi 2.1 modules are built with GCC 4.8; same layout for 32 and 64 bits.
 *
 * Lock-free: a naocal stopped or killed at any moment must not block the robot's control loop. Each direction is a ring
 * buffer of messages and a count of those written. The writer fills the next slot, then increments the count. A reader
 * copies the newest message and reads the count again; if the writer has reached the slot meanwhile, it copies again.
 * The count of states is a futex that the robot's side wakes. */

#include <linux/futex.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

namespace naocal {
namespace shared {

static const char* const blockName = "/naocal";
static const uint32_t blockMagic = 0x6c61436e; /* "nCal" */
static const uint32_t blockVersion = 1;
enum { jointCount = 26, ringSize = 8, idLength = 32 };

/* Lists by joint in HULKs' order (protocol/JointOrder.hpp); units as in hardware/RobotInterface.hpp. */
struct State {
  uint32_t secondsLow, secondsHigh, nanoseconds; /* CLOCK_MONOTONIC */
  float angles[jointCount];
  float stiffness[jointCount];
  float current[jointCount];
  float temperature[jointCount];
  float status[jointCount];
  float accelerometer[3], gyroscope[3], torsoAngles[2];
  float forces[8], sonar[2];
  float touch[14]; /* LoLA's order: chest, head front, middle, rear, left foot left, right, left hand back, left, right,
                      right foot left, right, right hand back, left, right */
  float battery[4]; /* charge, status, current, temperature */
};

/* LEDs as in hardware/RobotInterface.hpp; colours as red, green, blue. */
struct Command {
  float angles[jointCount];
  float stiffness[jointCount]; /* 0 or less: motor off */
  float chest[3], leftFoot[3], rightFoot[3];
  float leftEye[8][3], rightEye[8][3];
  float leftEar[10], rightEar[10], skull[12];
};

struct Block {
  uint32_t magic, version;
  uint32_t size; /* of this struct */
  char bodyId[idLength], headId[idLength], bodyVersion[idLength], headVersion[idLength];
  uint32_t stateCount, commandCount;
  State states[ringSize];
  Command commands[ringSize];
};

/* Copies data shared with other threads; word-wise atomic: each word is either old or new. */
inline void copyWords(void* to, const void* from, size_t size) {
  for (size_t i = 0; i < size / 4; ++i) {
    const uint32_t word = __atomic_load_n(static_cast<const uint32_t*>(from) + i, __ATOMIC_RELAXED);
    __atomic_store_n(static_cast<uint32_t*>(to) + i, word, __ATOMIC_RELAXED);
  }
}

/* Writes the next message of a ring buffer. Single writer. */
template <typename Message> void publish(Message* ring, uint32_t& count, const Message& message) {
  const uint32_t next = __atomic_load_n(&count, __ATOMIC_RELAXED);
  __atomic_thread_fence(__ATOMIC_SEQ_CST);
  copyWords(&ring[next % ringSize], &message, sizeof(Message));
  __atomic_store_n(&count, next + 1, __ATOMIC_RELEASE);
}

/* The newest message and its number, from 1 on; 0 if there is none, or if the writer overtakes 100 copies in a row. One
 * slot of the ring is reserved for the writer. */
template <typename Message> uint32_t newest(const Message* ring, const uint32_t& count, Message& message) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    const uint32_t before = __atomic_load_n(&count, __ATOMIC_ACQUIRE);
    if (before == 0) {
      return 0;
    }
    copyWords(&message, &ring[(before - 1) % ringSize], sizeof(Message));
    __atomic_thread_fence(__ATOMIC_SEQ_CST);
    if (__atomic_load_n(&count, __ATOMIC_RELAXED) - before < ringSize - 1) {
      return before;
    }
  }
  return 0;
}

/* wake: wakes all waiters on `count`. wait: waits while `count` equals `seen`, at most `timeout`. */
inline void wake(const uint32_t& count) {
  syscall(SYS_futex, &count, FUTEX_WAKE, 0x7fffffff, static_cast<void*>(0), static_cast<void*>(0), 0);
}
inline void wait(const uint32_t& count, uint32_t seen, const timespec& timeout) {
  syscall(SYS_futex, &count, FUTEX_WAIT, seen, &timeout, static_cast<void*>(0), 0);
}

} // namespace shared
} // namespace naocal
