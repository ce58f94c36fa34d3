#include "server/JobQueue.hpp"

namespace naocal {

JobQueue::JobQueue() : thread_{[this] { run(); }} {}

JobQueue::~JobQueue() {
  {
    const std::lock_guard lock{mutex_};
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void JobQueue::add(Job job) {
  {
    const std::lock_guard lock{mutex_};
    jobs_.push_back(std::move(job));
  }
  changed_.notify_all();
}

void JobQueue::run() {
  for (;;) {
    std::unique_lock lock{mutex_};
    changed_.wait(lock, [this] { return ends_ || !jobs_.empty(); });
    if (ends_) {
      return;
    }
    const Job job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    job();
  }
}

} // namespace naocal
