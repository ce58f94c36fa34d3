#include "framework/network/Outbox.hpp"

#include "framework/core/Module.hpp"

#include <boost/lockfree/spsc_queue.hpp>
#include <cerrno>
#include <cstring>
#include <sys/eventfd.h>
#include <system_error>
#include <unistd.h>

namespace naocal {

struct Outbox::Queue {
  boost::lockfree::spsc_queue<CycleReport*, boost::lockfree::capacity<8>> reports;
  int descriptor = ::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
};

Outbox::Outbox() : queue_{std::make_unique<Queue>()} {
  if (queue_->descriptor < 0) {
    throw std::system_error{errno, std::generic_category(), "the system gives no event descriptor"};
  }
}

Outbox::~Outbox() {
  while (take()) {
  }
  ::close(queue_->descriptor);
}

int Outbox::descriptor() const {
  return queue_->descriptor;
}

void Outbox::onCycleEnd(TimePoint time, const std::vector<AnyProduction*>& productions) {
  std::unique_ptr<CycleReport> report;
  for (const AnyProduction* production : productions) {
    if (production->isWanted() && production->wasEdited()) {
      if (auto sample = production->sample()) {
        report = report ? std::move(report) : std::make_unique<CycleReport>(CycleReport{time, {}});
        report->items.push_back({production, time, std::move(sample)});
      }
    }
  }
  if (report && queue_->reports.push(report.get())) {
    static_cast<void>(report.release());
    const std::uint64_t one = 1;
    static_cast<void>(!::write(queue_->descriptor, &one, sizeof one)); // a saturated counter also wakes the reader
  }
}

std::unique_ptr<CycleReport> Outbox::take() {
  CycleReport* report = nullptr;
  if (!queue_->reports.pop(report)) {
    return nullptr;
  }
  return std::unique_ptr<CycleReport>{report};
}

} // namespace naocal
