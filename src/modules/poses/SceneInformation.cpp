#include "math/LinearAlgebra.hpp"
#include "poses/Scene.hpp"
#include "residuals/FloorContact.hpp"

#include <cmath>

namespace naocal {

namespace {

/// What pixels of the corners seen tell about the picture's six-dimensional motion.
Eigen::Matrix<double, 6, 6> ofMotion(const ProjectedBlocks& corners, const std::vector<int>& seen) {
  Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
  for (const int corner : seen) {
    const ProjectedBlock& block = corners[static_cast<std::size_t>(corner / 4)];
    Eigen::Matrix<double, 6, 2> rows;
    for (int i = 0; i < 6; ++i) {
      rows.row(i) << block.rowsU[i][corner % 4], block.rowsV[i][corner % 4];
    }
    sum += rows * rows.transpose();
  }
  return sum;
}

} // namespace

Eigen::MatrixXd Scene::information(const Belief& belief, const Posture& torsoFromLink, double pixel) const {
  const std::size_t mounts = robot_.joints.size(), boards = mounts + 3 * robot_.cameras.size();
  const auto size = at(boards + 3 * boards_.size());
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(size, size);
  Belief own = belief;
  for (const Outlook& outlook : outlooks_) {
    const Projection seen = projection(outlook, own, torsoFromLink);
    if (seen.seen.empty()) {
      continue;
    }
    std::vector<std::size_t> quantities, unknowns; // what moves the picture, and the unknown behind it
    const auto add = [&](std::size_t quantity, std::size_t unknown) {
      quantities.push_back(quantity);
      unknowns.push_back(unknown);
    };
    for (const std::size_t joint : outlook.view.joints()) {
      add(quantities_.angle(joint), robot_.joints[joint].motor);
    }
    const std::size_t board = outlook.view.board();
    for (const std::size_t i : {0, 1, 2}) {
      add(quantities_.mountRotation() + i, mounts + 3 * outlook.camera + i);
      add(quantities_.board(board) + (i < 2 ? i : 5), boards + 3 * board + i);
    }
    Eigen::MatrixXd motion(6, at(quantities.size()));
    outlook.view.motion(robot_, seen.attitude, own, torsoFromLink, quantities, {}, motion);
    const Eigen::MatrixXd ofQuantities =
        motion.transpose() * ofMotion(seen.corners, seen.seen) * motion / (pixel * pixel);
    for (std::size_t a = 0; a < unknowns.size(); ++a) {
      for (std::size_t b = 0; b < unknowns.size(); ++b) {
        information(at(unknowns[a]), at(unknowns[b])) += ofQuantities(at(a), at(b));
      }
    }
  }
  if (otherSole_) {
    addFloorContact(belief, torsoFromLink, information);
  }
  return information;
}

void Scene::addFloorContact(const Belief& belief, const Posture& torsoFromLink, Eigen::MatrixXd& information) const {
  const Attitude attitude = otherSole_->pathAttitude(robot_, belief, torsoFromLink);
  const std::vector<std::size_t>& joints = otherSole_->joints();
  std::vector<std::size_t> quantities;
  for (const std::size_t joint : joints) {
    quantities.push_back(quantities_.angle(joint));
  }
  Eigen::MatrixXd motion(6, at(joints.size()));
  otherSole_->motion(robot_, attitude, belief, torsoFromLink, quantities, {}, motion);
  const Eigen::MatrixXd slopes = floorContactByMotion(attitude.opticalFromWorld.rotation.col(2)) * motion;
  const Eigen::MatrixXd told = slopes.transpose() * slopes;
  for (std::size_t a = 0; a < joints.size(); ++a) {
    for (std::size_t b = 0; b < joints.size(); ++b) {
      information(at(robot_.joints[joints[a]].motor), at(robot_.joints[joints[b]].motor)) += told(at(a), at(b));
    }
  }
}

Eigen::MatrixXd Scene::priorInformation() const {
  // Offsets are uniform within 6.5 degrees and cameras turned by up to 2; boards lie about where they should.
  const double offset = radians(6.5) / std::sqrt(3.0), mount = radians(2) / std::sqrt(3.0); // [rad]
  constexpr double board = 0.1;                                                             // [m] and [rad]
  const auto offsets = at(robot_.joints.size()), mounts = at(3 * robot_.cameras.size());
  Eigen::VectorXd sigma = Eigen::VectorXd::Constant(offsets + mounts + at(3 * boards_.size()), board);
  sigma.head(offsets).setConstant(offset);
  sigma.segment(offsets, mounts).setConstant(mount);
  return sigma.array().square().inverse().matrix().asDiagonal();
}

} // namespace naocal
