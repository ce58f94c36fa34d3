#include "math/Angles.hpp"
#include "math/RigidTransform.hpp"
#include "setups/Catalogue.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

/// The rotations that take axes to axes, without the identity.
std::vector<Eigen::Matrix3d> axisRotations() {
  std::vector<Eigen::Matrix3d> rotations;
  std::array<int, 3> order{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();
      for (int axis = 0; axis < 3; ++axis) {
        rotation(order[static_cast<std::size_t>(axis)], axis) = (signs >> axis) % 2 == 0 ? 1 : -1;
      }
      if (rotation.determinant() > 0 && !rotation.isIdentity()) {
        rotations.push_back(rotation);
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return rotations;
}

/// How the true camera is turned in the one that the file names; axes forward, left, up.
std::string describeTurn(const Eigen::Matrix3d& rotation, bool isOptical) {
  if (rotation.isApprox(isOptical ? Eigen::Matrix3d{opticalFromCamera().transpose()} : opticalFromCamera())) {
    return isOptical ? "they point forward, left and up (axes \"forward\"), not right, down and forward"
                     : "they point right, down and forward (axes \"optical\"), not forward, left and up";
  }
  const Eigen::AngleAxisd turn{rotation};
  const std::array<std::string, 3> names{"its line of sight", "its horizontal axis", "its vertical axis"};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (std::abs(turn.axis()[axis]) > 0.99) {
      return fmt::format("they are turned by {:.0f}° about {}", degrees(turn.angle() * turn.axis()[axis]),
                         names[static_cast<std::size_t>(axis)]);
    }
  }
  return "they are exchanged";
}

} // namespace

/// The axes of a camera's mount are others than the file says: forward for optical, an image turned by 90° or 180°.
SetUp cameraAxes() {
  return {.name = "cameraAxes",
          .description = "the axes of the camera's mount are others than the file says",
          .question = "Where do the axes of the link that carries camera {} point, and how is the camera turned on it?",
          .listPlaces =
              [](const Measurements& measurements) {
                std::vector<std::string> names;
                for (std::size_t i = 0; i < measurements.robot.cameras.size(); ++i) {
                  const bool isUsed = std::any_of(measurements.pictures.begin(), measurements.pictures.end(),
                                                  [&](const ImageObservation& picture) { return picture.camera == i; });
                  if (isUsed && !measurements.isCameraUnknown(i)) {
                    names.push_back(measurements.robot.cameras[i].name);
                  }
                }
                return names;
              },
          .listMendings =
              [](const Measurements& measurements, const std::string& camera) {
                const auto& mountings = measurements.sets->front().mountings;
                const auto mounting = mountings.find(camera);
                const bool isOptical = mounting != mountings.end() && mounting->second.isOptical;
                std::vector<Mending> ways;
                for (const Eigen::Matrix3d& rotation : axisRotations()) {
                  ways.push_back({fmt::format("the axes of camera {} are not those of the file: {}", camera,
                                              describeTurn(rotation, isOptical)),
                                  [camera, rotation](Recording& recording) {
                                    if (const auto index = recording.robot.cameraIndex(camera)) {
                                      Eigen::Matrix3d& mount = recording.robot.cameras[*index].rotation;
                                      mount = mount * rotation;
                                    }
                                  }});
                }
                return ways;
              }};
}

} // namespace naocal
