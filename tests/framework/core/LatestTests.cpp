#include "framework/core/Latest.hpp"

#include <catch2/catch.hpp>
#include <thread>
#include <vector>

namespace naocal {

TEST_CASE("the latest value is taken once and older ones are lost") {
  // Proves writing and taking in one thread.
  Latest<int> latest;
  CHECK(latest.take() == nullptr);
  latest.write(1);
  latest.write(2);
  REQUIRE(latest.take() != nullptr);
  CHECK(latest.take() == nullptr);
  latest.write(3);
  CHECK(*latest.take() == 3);
}

TEST_CASE("the latest value is handed over whole while it is written") {
  // Proves that across two threads values increase and are complete, and that the last one arrives.
  Latest<std::vector<int>> latest;
  std::thread writer{[&] {
    for (int i = 1; i <= 50000; ++i) {
      latest.write(std::vector<int>(5, i));
    }
  }};
  int last = 0;
  while (last < 50000) {
    if (const auto* value = latest.take()) {
      const bool newer = value->front() > last;
      const bool whole = *value == std::vector<int>(5, value->front());
      if (!newer || !whole) {
        FAIL_CHECK("an old or broken value: " << value->front() << " after " << last);
        break;
      }
      last = value->front();
    } else {
      std::this_thread::yield();
    }
  }
  writer.join();
}

} // namespace naocal
