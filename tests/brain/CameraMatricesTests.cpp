#include "brain/CameraMatrices.hpp"

#include "math/Angles.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {

TEST_CASE("the panel's matrices are those of a robot that stands upright") {
  // Proves frames, units and directions from the drawing's lengths: straight legs, head turned left.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  JointSample moment;
  moment.angles[*jointIndex("HeadYaw")] = radians(90);
  const nlohmann::json shown = computePanelCameraPose(robot, moment, CameraName::top, {});
  const auto position = [](const nlohmann::json& matrix) {
    const auto numbers = matrix[1].get<std::vector<double>>();
    return Eigen::Vector3d{numbers.data()};
  };
  CHECK(shown["imageInfos"]["identification"] == "top");
  CHECK((position(shown["ground2Torso"]) - Eigen::Vector3d{0, 0, -333.09}).norm() < 0.01); // mm
  CHECK(shown["torso2Head"][0][0].get<double>() == Approx(radians(90)));
  CHECK(shown["torso2Head"][0][3].get<double>() == Approx(-1)); // the inverse rotation: back to the right
  CHECK((position(shown["torso2Head"]) - Eigen::Vector3d{0, 0, -126.5}).norm() < 0.01);
  // Distance of the ground's origin from a camera 0.5232 m above it and 0.0587 m in front of the neck, pitched down by
  // 1.2 degrees [m].
  CHECK(position(shown["imageInfos"]["ground2Camera"]).norm() == Approx(std::hypot(0.05871, 0.52323)).margin(1e-5));
}

TEST_CASE("a tilted torso moves the ground, not the head") {
  // Proves that the pitch is that of the inertial unit: direction of the ground's z axis for a torso leaning forward.
  // Roll is not tested.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  JointSample moment;
  moment.tilt = {0, radians(10)};
  const PanelCameraPose matrices = computePanelCameraPose(robot, moment, CameraName::bottom, {});
  const Eigen::Vector3d up = matrices.torsoFromGround.linear().col(2);
  CHECK(up.x() == Approx(-std::sin(radians(10))));
  CHECK(matrices.headFromTorso.linear().isIdentity(1e-12));
}

} // namespace naocal
