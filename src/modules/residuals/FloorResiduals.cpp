#include "math/LinearAlgebra.hpp"
#include "residuals/FloorContact.hpp"
#include "residuals/Workspace.hpp"

#include <Eigen/Geometry>

namespace naocal {

/// The other sole's height over the floor and its tilt are zero but for `FloorContact`; in units of pixels, as all sums
/// are.
void Residuals::addFloorContact(const Picture& picture, const PreparedPicture& prepared, Workspace& work,
                                PosePart& part) const {
  const View& sole = *picture.otherSole;
  const Attitude attitude = sole.pathAttitude(measurements_.robot, work.belief, work.torsoFromLink);
  const Eigen::Vector3d normal = attitude.opticalFromWorld.rotation.col(2);
  const Eigen::Vector3d scale =
      noise_.pixel * Eigen::Vector3d{1 / FloorContact::height, 1 / FloorContact::tilt, 1 / FloorContact::tilt};
  const Eigen::Matrix<double, 3, 6> byMotion = noise_.pixel * floorContactByMotion(normal);
  const Eigen::Vector3d residual =
      scale.cwiseProduct(Eigen::Vector3d{-normal.dot(attitude.opticalFromWorld.translation), normal.x(), normal.y()});
  work.motion.resize(6, at(prepared.floor.quantities.size()));
  sole.motion(measurements_.robot, attitude, work.belief, work.torsoFromLink, prepared.floor.quantities, {},
              work.motion);
  work.add(byMotion.transpose() * byMotion, byMotion.transpose() * residual, work.motion, prepared.floor);
  work.cost += residual.squaredNorm() / (noise_.pixel * noise_.pixel);
  part.squares += residual.squaredNorm();
  part.numbers += 3;
  part.freedom += 3;
}

/// The floor's normal in the torso is what the inertial unit says, but for `ImuReading`:
///   n_imu = (Ry(angleY) Rx(angleX) Ry(pitch) Rx(roll))^T z, roll and pitch the unit's tilt
/// Its two level components count; d(n) = omega x n.
void Residuals::addImuReading(const Picture& picture, const PreparedPicture& prepared, Workspace& work,
                              PosePart& part) const {
  const View& torso = *prepared.torso;
  const Quantities& quantities = measurements_.quantities;
  const Attitude attitude = torso.pathAttitude(measurements_.robot, work.belief, work.torsoFromLink);
  const Eigen::Vector3d normal = attitude.opticalFromWorld.rotation.col(2);
  const double roll = work.belief.imuTilt()[0], pitch = work.belief.imuTilt()[1];
  const Eigen::Vector2d reading = picture.instant.imu;
  const Eigen::Vector3d byUnit = (rotationY(reading.y()) * rotationX(reading.x())).row(2); // in the unit's frame
  const Eigen::Vector3d pitched = rotationY(-pitch) * byUnit, told = rotationX(-roll) * pitched;
  const double scale = noise_.pixel / ImuReading::angle;

  Eigen::Matrix<double, 2, 8> byMotion = Eigen::Matrix<double, 2, 8>::Zero();
  byMotion.leftCols<3>() = -crossMatrix(normal).topRows<2>();
  byMotion.col(6) = Eigen::Vector3d::UnitX().cross(told).head<2>();
  byMotion.col(7) = (rotationX(-roll) * Eigen::Vector3d::UnitY().cross(pitched)).head<2>();
  byMotion *= scale;
  const Eigen::Vector2d residual = scale * (normal - told).head<2>();
  work.motion.resize(8, at(prepared.imu.quantities.size()));
  torso.motion(measurements_.robot, attitude, work.belief, work.torsoFromLink, prepared.imu.quantities, {},
               work.motion);
  for (std::size_t i = 0; i < prepared.imu.quantities.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      work.motion(at(6 + k), at(i)) = prepared.imu.quantities[i] == quantities.imuTilt() + k ? 1 : 0;
    }
  }
  work.add(byMotion.transpose() * byMotion, byMotion.transpose() * residual, work.motion, prepared.imu);
  work.cost += residual.squaredNorm() / (noise_.pixel * noise_.pixel);
  part.squares += residual.squaredNorm();
  part.numbers += 2;
  part.freedom += 2;
}

} // namespace naocal
