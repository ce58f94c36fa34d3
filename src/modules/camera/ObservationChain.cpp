#include "camera/ObservationChain.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace naocal {

namespace {

/// Shift by an entry of the lens, in the order of `ModelState::lens`.
CornerShift shiftByLens(std::size_t entry, const Eigen::Matrix<double, 9, 1>& lens, const ProjectedBlock& projected) {
  const double fx = lens[0], fy = lens[1];
  const Double4 &x = projected.x, &y = projected.y;
  const Double4 rr = x * x + y * y;
  switch (entry) {
  case 0:
    return {(projected.u - lens[2]) / fx, {}};
  case 1:
    return {{}, (projected.v - lens[3]) / fy};
  case 2:
    return {Double4{} + 1, {}};
  case 3:
    return {{}, Double4{} + 1};
  case 4:
    return {fx * x * rr, fy * y * rr};
  case 5:
    return {fx * x * rr * rr, fy * y * rr * rr};
  case 6:
    return {fx * 2 * x * y, fy * (rr + 2 * y * y)};
  case 7:
    return {fx * (rr + 2 * x * x), fy * 2 * x * y};
  default:
    return {fx * x * rr * rr * rr, fy * y * rr * rr * rr};
  }
}

/// Shift by the read-out time of a row; `cy`: row of the principal point [px].
CornerShift shiftByRowTime(const Eigen::Matrix<double, 6, 1>& drift, double cy, const CornerBlock& corners,
                           const ProjectedBlock& projected) {
  CornerShift shift;
  for (Eigen::Index i = 0; i < 6; ++i) {
    shift.u += drift[i] * projected.rowsU[i];
    shift.v += drift[i] * projected.rowsV[i];
  }
  shift.u *= corners.v - cy;
  shift.v *= corners.v - cy;
  return shift;
}

/// Shift by the scale or the bow of the board.
CornerShift shiftByBoard(std::size_t extra, const Eigen::Matrix3d& r, const CornerBlock& corners,
                         const ProjectedBlock& projected) {
  Double4 mx = corners.x, my = corners.y, mz = corners.z; // motion of the point in the board frame
  if (extra == boardBowExtra) {
    mx = my = Double4{};
    mz = corners.bulge;
  }
  const Double4 dx = r(0, 0) * mx + r(0, 1) * my + r(0, 2) * mz;
  const Double4 dy = r(1, 0) * mx + r(1, 1) * my + r(1, 2) * mz;
  const Double4 dz = r(2, 0) * mx + r(2, 1) * my + r(2, 2) * mz;
  return {projected.rowsU[3] * dx + projected.rowsU[4] * dy + projected.rowsU[5] * dz,
          projected.rowsV[3] * dx + projected.rowsV[4] * dy + projected.rowsV[5] * dz};
}

} // namespace

ObservationChain::ObservationChain(const Robot& robot, const StateLayout& quantities, std::size_t camera,
                                   const ChainTarget& target, std::optional<std::size_t> support)
    : ObservationChain{robot, quantities, std::optional{camera}, support.value_or(robot.cameras[camera].link), target} {
}

ObservationChain ObservationChain::betweenLinks(const Robot& robot, const StateLayout& quantities, std::size_t eyeLink,
                                                std::size_t sole) {
  return {robot, quantities, std::nullopt, eyeLink, {.link = sole, .inWorld = true, .board = 0}};
}

ObservationChain::ObservationChain(const Robot& robot, const StateLayout& quantities, std::optional<std::size_t> camera,
                                   std::size_t eyeLink, const ChainTarget& target)
    : quantities_{quantities}, camera_{camera}, eye_{eyeLink},
      eyeInWorld_{camera && robot.cameras[*camera].inWorld}, target_{target}, side_(robot.links.size(), 0) {
  links_ = ancestorLinks(robot, {eyeLink, target.link});
  for (std::optional<std::size_t> link = eyeLink; link; link = robot.links[*link].parent) {
    side_[*link] -= 1;
  }
  for (std::optional<std::size_t> link = target.link; link; link = robot.links[*link].parent) {
    side_[*link] += 1; // links that carry both cancel
  }
  for (std::size_t link : links_) {
    if (side_[link] != 0 && robot.links[link].joint) {
      joints_.push_back(*robot.links[link].joint);
    }
  }
}

CameraFrames ObservationChain::pathFrames(const PosedRobot& posed) const {
  const auto& [robot, modelState, torsoFromLink] = posed;
  const RigidTransform linkFromEye = camera_ ? linkFromOptical(robot.cameras[*camera_], modelState) : RigidTransform{};
  CameraFrames result;
  if (eyeInWorld_) {
    result.opticalFromWorld = linkFromEye.inverse();
    result.opticalFromTorso =
        result.opticalFromWorld * transformFromPlacement(modelState.worldFromSupport()) * torsoFromLink[eye_].inverse();
    result.opticalFromTarget = result.opticalFromTorso * torsoFromLink[target_.link];
    return result;
  }
  result.opticalFromTorso = (torsoFromLink[eye_] * linkFromEye).inverse();
  result.opticalFromTarget = result.opticalFromTorso * torsoFromLink[target_.link];
  result.opticalFromWorld = result.opticalFromTarget * transformFromPlacement(modelState.worldFromSupport()).inverse();
  return result;
}

/// opticalFromParent of the frame that the board's placement counts from.
RigidTransform ObservationChain::boardParent(const CameraFrames& attitude) const {
  const RigidTransform& parent = target_.inWorld ? attitude.opticalFromWorld : attitude.opticalFromTarget;
  return reference_ ? parent * *reference_ : parent;
}

void ObservationChain::placeBoard(const RigidTransform& linkFromBoard, CameraFrames& attitude) const {
  attitude.opticalFromBoard = boardParent(attitude) * linkFromBoard;
}

CameraFrames ObservationChain::cameraFrames(const PosedRobot& posed) const {
  CameraFrames result = pathFrames(posed);
  placeBoard(transformFromPlacement(posed.modelState.boardPlacement(target_.board)), result);
  return result;
}

bool ObservationChain::project(const CameraFrames& attitude, const ModelState& modelState, const CornerBlocks& corners,
                               ProjectedBlocks& projected) const {
  constexpr double nearest = 1e-3; // [m]: depth below which a corner has no projection
  const Eigen::Matrix3d r = attitude.opticalFromBoard.rotation;
  const Eigen::Vector3d t = attitude.opticalFromBoard.translation;
  const Eigen::Matrix<double, 9, 1> lens = modelState.lens();
  const double fx = lens[0], fy = lens[1], cx = lens[2], cy = lens[3];
  const double k1 = lens[4], k2 = lens[5], p1 = lens[6], p2 = lens[7], k3 = lens[8];
  const double scale = 1 + modelState.boardScale(target_.board), bow = modelState.boardBow(target_.board);
  const double rowTime = modelState.rowTime();
  const Eigen::Matrix<double, 6, 1> drift = attitude.drift;
  projected.resize(corners.size());
  Double4 least = Double4{} + 1;
  dispatchSimd([ =, &corners, &projected, &least ]() __attribute__((always_inline)) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const CornerBlock& corner = corners[i];
      ProjectedBlock& out = projected[i];
      const Double4 px = scale * corner.x, py = scale * corner.y, pz = scale * corner.z + bow * corner.bulge;
      Double4 depth = r(2, 0) * px + r(2, 1) * py + r(2, 2) * pz + t[2];
      Double4 across = r(0, 0) * px + r(0, 1) * py + r(0, 2) * pz + t[0];
      Double4 down = r(1, 0) * px + r(1, 1) * py + r(1, 2) * pz + t[1];
      if (rowTime != 0) {
        const Double4 time = rowTime * (corner.v - cy), a = across, b = down, c = depth;
        across += time * (drift[1] * c - drift[2] * b + drift[3]);
        down += time * (drift[2] * a - drift[0] * c + drift[4]);
        depth += time * (drift[0] * b - drift[1] * a + drift[5]);
      }
      least = depth < least ? depth : least;
      const Double4 inverseDepth = 1 / depth;
      const Double4 x = across * inverseDepth, y = down * inverseDepth;
      const Double4 rr = x * x + y * y;
      const Double4 radial = 1 + rr * (k1 + rr * (k2 + rr * k3));
      const Double4 radialSlope = 2 * (k1 + rr * (2 * k2 + rr * (3 * k3)));
      out.x = x;
      out.y = y;
      out.u = fx * (x * radial + 2 * p1 * x * y + p2 * (rr + 2 * x * x)) + cx;
      out.v = fy * (y * radial + p1 * (rr + 2 * y * y) + 2 * p2 * x * y) + cy;
      const Double4 mixed = x * y * radialSlope + 2 * p1 * x + 2 * p2 * y;
      const Double4 slopes[2][2] = {{fx * (radial + x * x * radialSlope + 2 * p1 * y + 6 * p2 * x), fx * mixed},
                                    {fy * mixed, fy * (radial + y * y * radialSlope + 6 * p1 * y + 2 * p2 * x)}};
      Double4* rows[2] = {out.rowsU, out.rowsV};
      for (int axis = 0; axis < 2; ++axis) {
        const Double4 a = slopes[axis][0], b = slopes[axis][1], c = -(a * x + b * y);
        Double4* row = rows[axis]; // gradient with respect to X, Y, Z: (a, b, c) / Z; first three rows: p x gradient
        row[0] = y * c - b;
        row[1] = a - x * c;
        row[2] = x * b - y * a;
        row[3] = a * inverseDepth;
        row[4] = b * inverseDepth;
        row[5] = c * inverseDepth;
      }
    }
  });
  return std::min({least[0], least[1], least[2], least[3]}) >= nearest;
}

CornerShift ObservationChain::shiftByExtra(std::size_t extra, const CameraFrames& attitude,
                                           const ModelState& modelState, const CornerBlock& corners,
                                           const ProjectedBlock& projected) {
  if (extra < lensCount) {
    return shiftByLens(extra, modelState.lens(), projected);
  }
  return extra == rowTimeExtra ? shiftByRowTime(attitude.drift, modelState.lens()[3], corners, projected)
                               : shiftByBoard(extra, attitude.opticalFromBoard.rotation, corners, projected);
}

std::optional<std::size_t> ObservationChain::extraIndex(std::size_t quantity) const {
  if (quantity >= quantities_.lens() && quantity < quantities_.lens() + lensCount) {
    return quantity - quantities_.lens();
  }
  if (quantity == quantities_.board(target_.board) + 6) {
    return boardScaleExtra;
  }
  if (quantity == quantities_.board(target_.board) + 7) {
    return boardBowExtra;
  }
  return quantity == quantities_.rowTime() ? std::optional{rowTimeExtra} : std::nullopt;
}

/// Angles, axes and lengths move what lies beyond the link; a link that carries the camera moves the scene backwards.
Twist ObservationChain::linkMotion(const PosedRobot& posed, const CameraFrames& attitude, std::size_t quantity) const {
  const auto& [robot, modelState, torsoFromLink] = posed;
  if (quantity >= quantities_.length(0)) {
    Twist sum = Twist::Zero();
    const std::size_t length = quantity - quantities_.length(0);
    for (std::size_t index : links_) {
      const Link& link = robot.links[index];
      for (const Link::Stretch& stretch : link.stretches) {
        if (stretch.length == length && link.parent) {
          sum.tail<3>() += side_[index] * (attitude.opticalFromTorso.rotation *
                                           (torsoFromLink[*link.parent].rotation * stretch.direction));
        }
      }
    }
    return sum;
  }
  const bool isAngle = quantity < quantities_.axis(0);
  const std::size_t joint = isAngle ? quantity : (quantity - quantities_.axis(0)) / 3;
  const std::size_t link = robot.joints[joint].link;
  if (side_[link] == 0) {
    return Twist::Zero();
  }
  const RigidTransform& torsoFromThis = torsoFromLink[link];
  if (robot.joints[joint].isPrismatic) {
    // a shift by axis * q: by q along the axis, by a component of the axis along that of the link, times q
    const Eigen::Vector3d shift =
        isAngle ? Eigen::Vector3d{modelState.axis(joint)}
                : modelState.angle(joint) *
                      Eigen::Vector3d::Unit(static_cast<Eigen::Index>((quantity - quantities_.axis(0)) % 3));
    Twist twist = Twist::Zero();
    twist.tail<3>() = side_[link] * (attitude.opticalFromTorso.rotation * (torsoFromThis.rotation * shift));
    return twist;
  }
  Eigen::Vector3d turn = modelState.axis(joint);
  if (!isAngle) {
    // exp([a q]x) with a -> a + da rotates by J_l(a q) q da; seen from behind the rotation, by its transpose.
    const auto component = static_cast<Eigen::Index>((quantity - quantities_.axis(0)) % 3);
    const double angle = modelState.angle(joint);
    turn = angle * leftJacobian(modelState.axis(joint) * angle).row(component).transpose();
  }
  const Eigen::Vector3d turnInTorso = torsoFromThis.rotation * (side_[link] * turn);
  return twistAbout(attitude.opticalFromTorso.rotation * turnInTorso,
                    attitude.opticalFromTorso * torsoFromThis.translation);
}

/// The step to a joint moves what lies beyond it: along and about the axes of the joint's frame before its own motion.
Twist ObservationChain::linkStepMotion(const PosedRobot& posed, const CameraFrames& attitude, std::size_t joint,
                                       std::size_t number) const {
  const auto& [robot, modelState, torsoFromLink] = posed;
  const std::size_t link = robot.joints[joint].link;
  Twist twist = Twist::Zero();
  if (side_[link] == 0) {
    return twist;
  }
  Eigen::Matrix3d opticalFromDrawn = attitude.opticalFromTorso.rotation;
  if (robot.links[link].parent) {
    opticalFromDrawn *= torsoFromLink[*robot.links[link].parent].rotation;
  }
  if (robot.links[link].rotation) {
    opticalFromDrawn *= *robot.links[link].rotation;
  }
  if (number < 3) {
    twist.tail<3>() = side_[link] * opticalFromDrawn.col(static_cast<Eigen::Index>(number));
    return twist;
  }
  const auto step = modelState.linkStep(joint);
  const Eigen::Matrix3d first = rotationX(step[3]), second = first * rotationY(step[4]);
  const Eigen::Vector3d axis = number == 3   ? Eigen::Vector3d::UnitX()
                               : number == 4 ? Eigen::Vector3d{first.col(1)}
                                             : Eigen::Vector3d{second.col(2)};
  Eigen::Vector3d pivot = torsoFromLink[link].translation;
  if (robot.joints[joint].isPrismatic) {
    pivot -= torsoFromLink[link].rotation * modelState.axis(joint) * modelState.angle(joint);
  }
  return twistAbout(side_[link] * (opticalFromDrawn * axis), attitude.opticalFromTorso * pivot);
}

/// A motion of the camera in its link moves the scene in the opposite direction.
Twist ObservationChain::mountMotion(const Robot& robot, const ModelState& modelState, std::size_t number) const {
  const CameraMount& mount = robot.cameras[*camera_];
  const Eigen::Matrix3d opticalFromLink = linkFromOptical(mount, modelState).rotation.transpose();
  Twist twist = Twist::Zero();
  if (number < 3) {
    twist.tail<3>() = -opticalFromLink.col(static_cast<Eigen::Index>(number));
    return twist;
  }
  // linkFromCamera = R(mount) Rx(rx) Ry(ry) Rz(rz)
  const Eigen::Vector3d turn = modelState.mountRotation();
  Eigen::Matrix3d before = mount.rotation;
  if (number > 3) {
    before = before * rotationX(turn.x());
  }
  if (number > 4) {
    before = before * rotationY(turn.y());
  }
  twist.head<3>() = -opticalFromLink * before.col(static_cast<Eigen::Index>(number - 3));
  return twist;
}

void ObservationChain::setDrift(const PosedRobot& posed, const Eigen::VectorXd& velocity,
                                CameraFrames& attitude) const {
  attitude.drift.setZero();
  for (const std::size_t joint : joints_) {
    attitude.drift +=
        velocity[static_cast<Eigen::Index>(joint)] * linkMotion(posed, attitude, quantities_.angle(joint));
  }
}

void ObservationChain::fillMotionColumns(const PosedRobot& posed, const CameraFrames& attitude,
                                         const std::vector<std::size_t>& wanted, const std::vector<std::size_t>& extras,
                                         Eigen::Ref<Eigen::MatrixXd> columns) const {
  columns.setZero();
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const std::size_t quantity = wanted[i];
    auto column = columns.col(static_cast<Eigen::Index>(i));
    if (quantity < quantities_.mountTranslation()) {
      column.head<6>() = linkMotion(posed, attitude, quantity);
    } else if (quantity < quantities_.lens() && camera_) {
      column.head<6>() = mountMotion(posed.robot, posed.modelState, quantity - quantities_.mountTranslation());
    } else if (const auto number = camera_ ? extraIndex(quantity) : std::nullopt) {
      const auto row = std::find(extras.begin(), extras.end(), *number);
      assert(row != extras.end());
      column[6 + (row - extras.begin())] = 1;
    } else if (quantity >= quantities_.worldFromSupport() && quantity < quantities_.worldFromSupport() + 6 &&
               target_.inWorld != eyeInWorld_) {
      // the support moves in the world, so the world moves backwards in the support
      const double direction = eyeInWorld_ ? 1 : -1;
      column.head<6>() = direction * placementMotion(attitude.opticalFromWorld, posed.modelState.worldFromSupport(),
                                                     quantity - quantities_.worldFromSupport());
    } else if (camera_ && quantity >= quantities_.board(target_.board) &&
               quantity < quantities_.board(target_.board) + 6) {
      column.head<6>() = placementMotion(boardParent(attitude), posed.modelState.boardPlacement(target_.board),
                                         quantity - quantities_.board(target_.board));
    } else if (const auto joint = quantities_.jointOfStep(quantity)) {
      column.head<6>() = linkStepMotion(posed, attitude, *joint, quantity - quantities_.linkStep(*joint));
    }
  }
}

} // namespace naocal
