#include "robot/Urdf.hpp"

#include "fuzz/driver/Reader.hpp"

namespace naocal {
namespace {

void readUrdf(std::string_view bytes) {
  parseUrdf(std::string{bytes}, "robot.urdf");
}

const Reader urdfReader{"urdf", readUrdf};

} // namespace
} // namespace naocal
