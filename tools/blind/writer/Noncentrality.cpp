#include "writer/Noncentrality.hpp"

#include "writer/Jacobian.hpp"

#include <cmath>
#include <map>

namespace blind {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

} // namespace

Noncentrality::Noncentrality(const Robot& robot, const Session& session, const NoiseRegime& noise) {
  const Jacobian jacobian{robot, session};
  unknowns_ = jacobian.unknowns();

  struct Member {
    std::size_t sight;
    Index row;
  };
  std::map<int, std::vector<Member>> poses;
  Index row = 0;
  for (std::size_t sight = 0; sight < session.sights.size(); ++sight) {
    poses[session.readings[session.sights[sight].reading].pose].push_back({sight, row});
    row += 2 * static_cast<Index>(session.sights[sight].ids.size());
  }
  const double ofApproach = std::hypot(encoderStep / std::sqrt(12.0), noise.stiction / std::sqrt(2.0));
  const double ofPose = noise.stiction / std::sqrt(2.0);
  constexpr Index chain = Jacobian::chainLength;
  for (const auto& [pose, members] : poses) {
    std::map<int, Index> approaches;
    std::map<std::pair<int, int>, Index> pictures;
    for (const Member& member : members) {
      const Sight& sight = session.sights[member.sight];
      approaches.try_emplace(session.readings[sight.reading].approachNumber, static_cast<Index>(approaches.size()));
      pictures.try_emplace({sight.reading, sight.camera}, static_cast<Index>(pictures.size()));
    }
    const Index biases = noise.pictureBias > 0 ? 2 * static_cast<Index>(pictures.size()) : 0;
    const Index deflections = chain * (static_cast<Index>(approaches.size()) + (ofPose > 0 ? 1 : 0));
    Index size = 0;
    for (const Member& member : members) {
      size += 2 * static_cast<Index>(session.sights[member.sight].ids.size());
    }
    Block block;
    block.shared = MatrixXd::Zero(size, deflections + biases);
    block.weights.resize(size);
    Index at = 0;
    for (const Member& member : members) {
      const Sight& sight = session.sights[member.sight];
      const Index height = 2 * static_cast<Index>(sight.ids.size());
      const auto byJoints = jacobian.byChain().middleRows(member.row, height);
      const Index approach = approaches.at(session.readings[sight.reading].approachNumber);
      block.shared.block(at, chain * approach, height, chain) = ofApproach * byJoints;
      if (ofPose > 0) {
        block.shared.block(at, deflections - chain, height, chain) = ofPose * byJoints;
      }
      for (Index i = 0; i < height; ++i) {
        block.rows.push_back(member.row + i);
        block.weights[at + i] = 1 / (sight.sigma * sight.sigma);
        if (biases > 0) {
          block.shared(at + i, deflections + 2 * pictures.at({sight.reading, sight.camera}) + i % 2) =
              noise.pictureBias;
        }
      }
      at += height;
    }
    block.inner.compute(MatrixXd::Identity(block.shared.cols(), block.shared.cols()) +
                        block.shared.transpose() * block.weights.asDiagonal() * block.shared);
    blocks_.push_back(std::move(block));
  }
  whitenedUnknowns_ = whitened(unknowns_);
  MatrixXd information = unknowns_.transpose() * whitenedUnknowns_;
  information.diagonal() += jacobian.priorWeights();
  information_.compute(information);
}

MatrixXd Noncentrality::whitened(const MatrixXd& columns) const {
  MatrixXd result{columns.rows(), columns.cols()};
  for (const Block& block : blocks_) {
    const MatrixXd weighted = block.weights.asDiagonal() * columns(block.rows, Eigen::all);
    result(block.rows, Eigen::all) =
        weighted - block.weights.asDiagonal() * (block.shared * block.inner.solve(block.shared.transpose() * weighted));
  }
  return result;
}

VectorXd Noncentrality::stacked(const Pictures& pictures, const Session& session) {
  std::vector<double> values;
  for (const Sight& sight : session.sights) {
    for (const Eigen::Vector2d& corner : pictures.corners(sight)) {
      values.push_back(corner.x());
      values.push_back(corner.y());
    }
  }
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

double Noncentrality::knownProduct(const VectorXd& left, const VectorXd& right) const {
  return left.dot(whitened(right).col(0));
}

double Noncentrality::product(const VectorXd& left, const VectorXd& right) const {
  const VectorXd leftPart = whitenedUnknowns_.transpose() * left, rightPart = whitenedUnknowns_.transpose() * right;
  return knownProduct(left, right) - leftPart.dot(information_.solve(rightPart));
}

} // namespace blind
