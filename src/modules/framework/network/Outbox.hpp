#pragma once

#include "framework/core/Module.hpp"
#include "framework/core/Thread.hpp"

#include <memory>
#include <string>
#include <vector>

namespace naocal {

/// The subscribed values of one cycle: copies, not encoded yet.
struct CycleReport {
  TimePoint time;
  struct Item {
    const AnyProduction* production;
    TimePoint time;
    std::shared_ptr<const Sample> sample;  // reset by encoding
    std::optional<EncodedImage> picture{}; // encoded image, if it is one
  };
  std::vector<Item> items; // same order as the thread's productions
};

/// Passes reports from a thread's cycle to the sockets' thread through a lock-free queue of 8 reports. The cycle never
/// waits: if the queue is full, the new report is dropped. The next cycle frees the samples that are no longer used: a
/// sockets' thread that has lost its processor would keep the lock of the allocator from which the cycle takes them.
class Outbox final : public CycleListener {
public:
  Outbox();
  ~Outbox() override;

  void onCycleEnd(TimePoint time, const std::vector<AnyProduction*>& productions) override;

  /// File descriptor that polls readable when there are reports.
  int descriptor() const;
  /// The oldest report; nullptr if there is none.
  std::unique_ptr<CycleReport> take();

private:
  struct Samples;
  struct Queue;
  std::unique_ptr<Queue> queue_;
};

} // namespace naocal
