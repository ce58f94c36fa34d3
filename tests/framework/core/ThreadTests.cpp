#include "framework/ShownRobot.hpp"
#include "framework/core/Thread.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <sched.h>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace naocal {
namespace {

/// Number of this process's threads at the niceness of background threads.
int countBackgroundThreads() {
  int count = 0;
  for (const auto& task : std::filesystem::directory_iterator{"/proc/self/task"}) {
    const int niceness = ::getpriority(PRIO_PROCESS, id_t(std::stoi(task.path().filename().string())));
    count += niceness == backgroundNiceness ? 1 : 0;
  }
  return count;
}

/// Waits for joined threads to leave the list of threads: a kernel removes them a little later, an emulator much later.
bool haveBackgroundThreadsEnded() {
  for (int i = 0; i < 6000 && countBackgroundThreads() > 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
  }
  return countBackgroundThreads() == 0;
}

int countProcessors() {
  cpu_set_t processors;
  REQUIRE(::sched_getaffinity(0, sizeof processors, &processors) == 0);
  return CPU_COUNT(&processors);
}

} // namespace

TEST_CASE("a background thread leaves motion a processor and goes after it") {
  // Proves the niceness and the number of processors of the calling thread alone.
  const int before = countProcessors();
  int niceness = 0, processors = 0;
  std::thread{[&] {
    runInBackground();
    niceness = ::getpriority(PRIO_PROCESS, id_t(::gettid()));
    processors = countProcessors();
  }}.join();
  CHECK(niceness == backgroundNiceness);
  CHECK(processors == std::max(before - 1, 1));
  CHECK(countProcessors() == before);
}

TEST_CASE("a thread with a short slice is an ordinary one otherwise") {
  // Proves that policy, niceness and processors stay; how soon it wakes is measured with the robot's process.
  const int before = countProcessors(), niceness = ::getpriority(PRIO_PROCESS, id_t(::gettid()));
  std::thread{[&] {
    requestShortSlice();
    CHECK(::sched_getscheduler(0) == SCHED_OTHER);
    CHECK(::getpriority(PRIO_PROCESS, id_t(::gettid())) == niceness);
    CHECK(countProcessors() == before);
  }}.join();
}

TEST_CASE("what clients send is accepted, read and encoded by background threads") {
  // Proves it for the two threads of the sockets, by their niceness.
  REQUIRE(haveBackgroundThreadsEnded()); // those of earlier tests
  ShownRobot robot;
  auto client = robot.debug();
  for (int i = 0; i < 1000 && countBackgroundThreads() < 2; ++i) {
    client.send(3);
    client.receive(4);
  }
  CHECK(countBackgroundThreads() == 2);
}

} // namespace naocal
