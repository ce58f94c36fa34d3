#include "math/Checkpoints.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <thread>

namespace naocal {

TEST_CASE("a checkpoint is visited by the innermost object of its thread, during its life") {
  // Proves nesting, the end of an object's life, also by an exception, and that other threads are left alone.
  int outer = 0, inner = 0;
  Checkpoints::reach();
  {
    const Checkpoints one{[&] { ++outer; }};
    Checkpoints::reach();
    std::thread{[] { Checkpoints::reach(); }}.join();
    {
      const Checkpoints other{[&] { ++inner; }};
      Checkpoints::reach();
    }
    CHECK_THROWS_AS(
        [] {
          const Checkpoints ending{[] { throw std::runtime_error{"enough"}; }};
          Checkpoints::reach();
        }(),
        std::runtime_error);
    Checkpoints::reach();
  }
  Checkpoints::reach();
  CHECK(outer == 2);
  CHECK(inner == 1);
}

} // namespace naocal
