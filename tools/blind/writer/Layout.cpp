#include "writer/Layout.hpp"

#include "writer/Pictures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blind {

std::vector<int> chainOf(const Drawing& drawing, int side) {
  std::vector<int> chain;
  for (const Drawing::Camera& camera : drawing.cameras) {
    for (int joint = camera.joint; joint >= 0 && chain.size() < 2; joint = drawing.joints[joint].parent) {
      chain.push_back(joint);
    }
  }
  for (int joint = drawing.soles[side].joint; joint >= 0; joint = drawing.joints[joint].parent) {
    const std::string& motor = drawing.joints[joint].drivenBy;
    chain.push_back(motor.empty() ? joint : drawing.joint(motor));
  }
  std::sort(chain.begin(), chain.end());
  return chain;
}

std::vector<FloorPlace> layOut(int boards, Chance& chance) {
  std::vector<FloorPlace> places;
  const double spread = 2.9, between = spread / (boards - 1); // [rad]
  for (int board = 0; board < boards; ++board) {
    const double bearing = -spread / 2 + board * between + chance.within(0.05);
    const double distance = chance.between(0.5, 0.66);
    const double yaw =
        bearing - std::numbers::pi / 2 + chance.within(0.3); // the sheet's upper edge away from the robot
    const Motion turned = placed(0, 0, yaw);
    const Eigen::Vector3d middle{0.5 * Sheet::squaresX * Sheet::square, -0.5 * Sheet::squaresY * Sheet::square, 0};
    const Eigen::Vector3d corner =
        Eigen::Vector3d{distance * std::cos(bearing), distance * std::sin(bearing), 0} - turned * middle;
    places.push_back({corner.x(), corner.y(), yaw});
  }
  return places;
}

} // namespace blind
