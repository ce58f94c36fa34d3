#include "Moment.hpp"
#include "framework/core/History.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <random>
#include <thread>
#include <vector>

namespace naocal {
namespace {

/// A value with redundant parts, to detect torn reads.
struct Pair {
  double first = 0, second = 0;
  std::array<double, 30> more{};
};
Pair interpolate(const Pair& from, const Pair& to, double fraction) {
  Pair result;
  result.first = naocal::interpolate(from.first, to.first, fraction);
  result.second = naocal::interpolate(from.second, to.second, fraction);
  result.more.fill(naocal::interpolate(from.more[29], to.more[29], fraction));
  return result;
}

} // namespace

TEST_CASE("a history knows nothing outside its entries") {
  // Proves absence before, after and without entries, and exact values at both ends. Threads are tested below.
  History<double, 8> history;
  CHECK_FALSE(history.at(at(0)));
  CHECK_FALSE(history.newest());
  history.push(at(1), 10);
  CHECK(history.at(at(1)) == 10.0);
  CHECK_FALSE(history.at(at(0.999)));
  CHECK_FALSE(history.at(at(1.001)));
  history.push(at(2), 20);
  CHECK(history.at(at(2)) == 20.0);
  CHECK(*history.at(at(1.25)) == Approx(12.5));
}

TEST_CASE("a history forgets its oldest entries and takes none that is not newer") {
  // Proves the capacity, and that only newer entries are accepted.
  History<double, 8> history;
  for (int i = 0; i < 100; ++i) {
    REQUIRE(history.push(at(i), i));
  }
  CHECK_FALSE(history.push(at(99), 5));
  CHECK_FALSE(history.push(at(98.5), 5));
  CHECK(history.newest()->value == 99);
  CHECK_FALSE(history.at(at(92.5)));
  CHECK(*history.at(at(93.5)) == Approx(93.5));
  std::vector<double> seen;
  history.visit(at(96), at(98), [&](const auto& entry) { seen.push_back(entry.value); });
  CHECK(seen == std::vector<double>{98, 97, 96});
}

TEST_CASE("a history interpolates between the neighbours of any time") {
  // Compares interpolation with the recorded function, at random times and uneven steps.
  std::mt19937 random{1};
  std::uniform_real_distribution<double> step{0.001, 0.1};
  History<double, 64> history;
  double time = 0;
  for (int i = 0; i < 200; ++i) {
    time += step(random);
    history.push(at(time), 3 * time);
  }
  const double span = 2;
  for (int i = 0; i < 500; ++i) {
    const double asked = time - std::uniform_real_distribution<double>{0, span}(random);
    REQUIRE(*history.at(at(asked)) == Approx(3 * asked).epsilon(1e-6));
  }
}

TEST_CASE("readers of a history never see half of an entry while it is written") {
  // Proves it for 100,000 entries written to a ring of four while two threads read; the thread sanitizer checks the same
  // test for data races.
  History<Pair, 4> history;
  std::atomic<bool> done{false};
  std::atomic<int> torn{0};
  std::atomic<int> started{0};
  const auto reader = [&] {
    ++started;
    while (!done) {
      if (const auto newest = history.newest()) {
        const auto value = history.at(newest->time);
        const bool whole =
            newest->value.first == -newest->value.second && newest->value.more[29] == newest->value.first;
        torn += !whole || (value && value->first != newest->value.first) ? 1 : 0;
      }
    }
  };
  std::thread one{reader}, two{reader};
  while (started < 2) {
    std::this_thread::yield();
  }
  for (int i = 1; i <= 100000; ++i) {
    Pair pair{double(i), -double(i), {}};
    pair.more.fill(i);
    history.push(at(i), pair);
  }
  done = true;
  one.join();
  two.join();
  CHECK(torn == 0);
  CHECK(history.newest()->value.first == 100000);
}

} // namespace naocal
