#include "framework/network/Outbox.hpp"

#include "framework/core/Module.hpp"

#include <boost/lockfree/queue.hpp>
#include <boost/lockfree/spsc_queue.hpp>
#include <cerrno>
#include <cstring>
#include <sys/eventfd.h>
#include <system_error>
#include <unistd.h>

namespace naocal {

/// What one cycle allocates for its report.
struct Outbox::Samples {
  struct Item {
    const AnyProduction* production;
    std::unique_ptr<const Sample> sample;
  };
  TimePoint time;
  std::vector<Item> items;
};

struct Outbox::Queue {
  /// Samples on their way back to the cycle, from any thread. Beyond 64 of them the returning thread frees them.
  class Returned {
  public:
    ~Returned() { free(); }
    void push(Samples* samples) {
      if (!queue_.push(samples)) {
        delete samples;
      }
    }
    void free() {
      queue_.consume_all([](Samples* samples) { delete samples; });
    }

  private:
    boost::lockfree::queue<Samples*, boost::lockfree::capacity<64>> queue_;
  };

  boost::lockfree::spsc_queue<Samples*, boost::lockfree::capacity<8>> reports;
  std::shared_ptr<Returned> returned = std::make_shared<Returned>();
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
  queue_->returned->free();
  std::unique_ptr<Samples> samples;
  for (const AnyProduction* production : productions) {
    if (production->isWanted() && production->wasEdited()) {
      if (auto sample = production->sample()) {
        samples = samples ? std::move(samples) : std::make_unique<Samples>(Samples{time, {}});
        samples->items.push_back({production, std::move(sample)});
      }
    }
  }
  if (samples && queue_->reports.push(samples.get())) {
    static_cast<void>(samples.release());
    const std::uint64_t one = 1;
    static_cast<void>(!::write(queue_->descriptor, &one, sizeof one)); // a saturated counter also wakes the reader
  }
}

std::unique_ptr<CycleReport> Outbox::take() {
  Samples* taken = nullptr;
  if (!queue_->reports.pop(taken)) {
    return nullptr;
  }
  const std::shared_ptr<Samples> samples{taken,
                                         [returned = queue_->returned](Samples* unused) { returned->push(unused); }};
  auto report = std::make_unique<CycleReport>(CycleReport{samples->time, {}});
  for (const Samples::Item& item : samples->items) {
    report->items.push_back({item.production, samples->time, {samples, item.sample.get()}});
  }
  return report;
}

} // namespace naocal
