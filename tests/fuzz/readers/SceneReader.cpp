#include "scenes/RobotScene.hpp"

#include "fuzz/driver/Reader.hpp"

namespace naocal {
namespace {

/// A scene of a robot with a URDF, of which only the names of joints are needed.
void readScene(std::string_view bytes) {
  CaptureSet robot;
  robot.model.clear();
  robot.urdf = "arm.urdf";
  robot.jointNames = {"turn", "elbow"};
  robot.stances.push_back({.id = 0, .supportFoot = SupportFoot::none, .placement = {}, .supportLinks = {}});
  parseRobotScene(std::string{bytes}, "scene.json", robot);
}

const Reader sceneReader{"scene", readScene};

} // namespace
} // namespace naocal
