#include "framework/network/Outbox.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

namespace naocal {
namespace {

/// Counts its copies that are destroyed, by thread.
struct Traced {
  std::atomic<int>* hereFreed = nullptr; // by the thread that made it
  std::atomic<int>* elsewhereFreed = nullptr;
  std::thread::id maker = std::this_thread::get_id();

  Traced() = default;
  Traced(const Traced&) = default;
  Traced& operator=(const Traced&) = default;
  ~Traced() {
    if (hereFreed != nullptr) {
      ++*(std::this_thread::get_id() == maker ? hereFreed : elsewhereFreed);
    }
  }
};
void to_json(nlohmann::json& out, const Traced&) {
  out = 1;
}

/// A cycle whose only production is subscribed to.
struct TracedCycle : Module {
  TracedCycle() : Module{"TracedCycle"} { traced.setWanted(true); }
  void cycle() override {}
  void end(Outbox& outbox) {
    traced.edit() = {};
    traced.edit().hereFreed = &hereFreed;
    traced.edit().elsewhereFreed = &elsewhereFreed;
    const int before = hereFreed;
    outbox.onCycleEnd({}, {&traced});
    freedInCycle += hereFreed - before;
    traced.edit() = {};
  }

  std::atomic<int> hereFreed{0}, elsewhereFreed{0};
  int freedInCycle = 0;
  Production<Traced> traced{*this, "traced"};
};

void elsewhere(const std::function<void()>& work) {
  std::thread{work}.join();
}

} // namespace

TEST_CASE("a cycle frees what its subscribers no longer use") {
  // Proves it for a report that another thread takes, keeps in part and gives back, for one that nobody takes, and for
  // more reports than find a place on the way back, which are freed where they were used.
  TracedCycle cycle;
  {
    Outbox outbox;
    std::shared_ptr<const Sample> kept;
    cycle.end(outbox);
    elsewhere([&] {
      const auto report = outbox.take();
      REQUIRE(report->items.size() == 1);
      CHECK(report->items.front().production == &cycle.traced);
      kept = report->items.front().sample;
      CHECK_FALSE(outbox.take());
    });
    cycle.end(outbox); // while the sample is in use
    CHECK(cycle.freedInCycle == 0);
    elsewhere([&] { kept.reset(); });
    cycle.end(outbox);
    CHECK(cycle.freedInCycle == 1);
    CHECK(cycle.elsewhereFreed == 0);

    std::vector<std::unique_ptr<CycleReport>> many;
    for (int i = 0; i < 70; ++i) {
      elsewhere([&] { many.push_back(outbox.take()); });
      cycle.end(outbox);
    }
    elsewhere([&] { many.clear(); });
    CHECK(cycle.elsewhereFreed == 70 - 64);
    cycle.end(outbox);
    CHECK(cycle.freedInCycle == 1 + 64);
  }
  CHECK(cycle.hereFreed + cycle.elsewhereFreed == 3 + 70 + 1);
}

} // namespace naocal
