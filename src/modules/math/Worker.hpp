#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace naocal {

/// Background thread that runs tasks in order. Tasks must not throw.
class Worker {
public:
  /// Tasks that the destructor completes. `presentTask`: drops the queued ones.
  enum class AtEnd { allTasks, presentTask };

  explicit Worker(AtEnd atEnd) : atEnd_{atEnd}, thread_{[this](const std::stop_token& stop) { run(stop); }} {}

  void enqueue(std::function<void()> task) {
    const std::lock_guard lock{mutex_};
    tasks_.push_back(std::move(task));
    added_.notify_one();
  }

  /// Blocks until all tasks are finished.
  void waitUntilIdle() {
    std::unique_lock lock{mutex_};
    finished_.wait(lock, [this] { return tasks_.empty(); });
  }

private:
  void run(const std::stop_token& stop) {
    std::unique_lock lock{mutex_};
    while (added_.wait(lock, stop, [this] { return !tasks_.empty(); })) {
      if (atEnd_ == AtEnd::presentTask && stop.stop_requested()) {
        return;
      }
      std::function<void()> task = std::move(tasks_.front());
      lock.unlock();
      task();
      task = nullptr; // unlocked: destroying a task may take long
      lock.lock();
      tasks_.pop_front();
      finished_.notify_all();
    }
  }

  const AtEnd atEnd_;
  std::mutex mutex_;
  std::condition_variable_any added_, finished_;
  std::deque<std::function<void()>> tasks_; // the first one is running
  std::jthread thread_;                     // last member: uses the others
};

} // namespace naocal
