#pragma once

#include "framework/core/Module.hpp"
#include "framework/core/Thread.hpp"

#include <memory>
#include <string>
#include <vector>

namespace naocal {

/// What somebody wanted to see of one cycle: copies, not yet text.
struct CycleReport {
  TimePoint time;
  struct Item {
    const AnyProduction* production;
    TimePoint time;
    std::unique_ptr<const Sample> sample;  // until it is encoded
    std::optional<EncodedImage> picture{}; // of a picture, once it is encoded
  };
  std::vector<Item> items; // in the order of the thread's productions
};

/// Carries reports from one thread's cycle to the sockets' thread. The cycle never waits: when the sockets' thread is
/// behind by `capacity` reports, the cycle's one is dropped.
class Outbox final : public CycleListener {
public:
  Outbox();
  ~Outbox() override;

  void onCycleEnd(TimePoint time, const std::vector<AnyProduction*>& productions) override;

  /// Readable (poll) when there are reports.
  int descriptor() const;
  /// The oldest report; nullptr: none.
  std::unique_ptr<CycleReport> take();

private:
  struct Queue;
  std::unique_ptr<Queue> queue_;
};

} // namespace naocal
