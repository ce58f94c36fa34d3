#include "robot/Urdf.hpp"

#include "fuzz/driver/Reader.hpp"

#include <nlohmann/json.hpp>

namespace naocal {
namespace {

void readUrdf(std::string_view bytes) {
  const Robot robot = parseUrdf(std::string{bytes}, "robot.urdf");
  nlohmann::json names{robot.model}; // whatever is written of a robot holds its names
  for (const Link& link : robot.links) {
    names.push_back(link.name);
  }
  for (const Joint& joint : robot.joints) {
    names.push_back(joint.name);
  }
  (void)names.dump();
}

const Reader urdfReader{"urdf", readUrdf};

} // namespace
} // namespace naocal
