#include "protocol/JointOrder.hpp"

#include <catch2/catch.hpp>

namespace naocal {

// Proves that the list of joints has no duplicates, and that an unknown name has no index.
TEST_CASE("every joint is found at its place by its name") {
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    CHECK(jointIndex(jointNames[joint]) == joint);
  }
  CHECK(!jointIndex("LeftKnee"));
}

} // namespace naocal
