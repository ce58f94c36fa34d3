#include "protocol/JointOrder.hpp"

#include <catch2/catch.hpp>

namespace naocal {

// Proves that the order of joints names every joint once.
TEST_CASE("every joint is found at its place by its name") {
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    CHECK(jointIndex(jointNames[joint]) == joint);
  }
  CHECK(!jointIndex("LeftKnee"));
}

} // namespace naocal
