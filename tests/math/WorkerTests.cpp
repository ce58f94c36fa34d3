#include "math/Worker.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <future>
#include <memory>
#include <thread>
#include <vector>

namespace naocal {
namespace {

constexpr int taskCount = 100;

/// Number of completed tasks after a worker was destroyed during its first one.
int countDone(Worker::AtEnd atEnd) {
  int done = 0;
  std::promise<void> begun;
  {
    Worker worker{atEnd};
    worker.enqueue([&begun] { begun.set_value(); });
    for (int i = 0; i < taskCount; ++i) {
      worker.enqueue([&done] {
        std::this_thread::sleep_for(std::chrono::milliseconds{5});
        ++done;
      });
    }
    begun.get_future().wait();
  }
  return done;
}

} // namespace

TEST_CASE("a worker ends after all of its tasks or after the present one") {
  // Proves both, with tasks that take half a second in total, and that tasks run in order.
  CHECK(countDone(Worker::AtEnd::allTasks) == taskCount);
  CHECK(countDone(Worker::AtEnd::presentTask) < taskCount);
  std::vector<int> order;
  Worker worker{Worker::AtEnd::presentTask};
  for (int i = 0; i < 10; ++i) {
    worker.enqueue([&order, i] { order.push_back(i); });
  }
  worker.waitUntilIdle();
  CHECK(order == std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
}

TEST_CASE("further tasks are taken while a worker destroys what a task held") {
  // Proves it with a destructor that waits for another task to be enqueued.
  std::promise<void> destroying, enqueued;
  std::future<void> wasEnqueued = enqueued.get_future();
  std::future_status status = std::future_status::deferred;
  {
    const auto destroy = [&](const int* number) {
      destroying.set_value();
      status = wasEnqueued.wait_for(std::chrono::seconds{5});
      delete number;
    };
    Worker worker{Worker::AtEnd::allTasks};
    worker.enqueue([held = std::shared_ptr<int>{new int{1}, destroy}] {});
    destroying.get_future().wait();
    worker.enqueue([] {});
    enqueued.set_value();
  }
  CHECK(status == std::future_status::ready);
}

} // namespace naocal
