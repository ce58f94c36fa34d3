#include "writer/ProjectedProduct.hpp"

#include <utility>

namespace blind {

using Eigen::MatrixXd;
using Eigen::VectorXd;

ProjectedProduct::ProjectedProduct(std::vector<PoseNoise> noise, MatrixXd unknowns, const VectorXd& priorWeights)
    : unknowns_{std::move(unknowns)} {
  for (PoseNoise& random : noise) {
    Block block{std::move(random), {}};
    const MatrixXd& shared = block.noise.shared;
    block.inner.compute(MatrixXd::Identity(shared.cols(), shared.cols()) +
                        shared.transpose() * block.noise.weights.asDiagonal() * shared);
    blocks_.push_back(std::move(block));
  }
  whitenedUnknowns_ = whitened(unknowns_);
  MatrixXd information = unknowns_.transpose() * whitenedUnknowns_;
  information.diagonal() += priorWeights;
  information_.compute(information);
}

MatrixXd ProjectedProduct::whitened(const MatrixXd& columns) const {
  MatrixXd result{columns.rows(), columns.cols()};
  for (const Block& block : blocks_) {
    const PoseNoise& noise = block.noise;
    const MatrixXd weighted = noise.weights.asDiagonal() * columns(noise.rows, Eigen::all);
    result(noise.rows, Eigen::all) =
        weighted - noise.weights.asDiagonal() * (noise.shared * block.inner.solve(noise.shared.transpose() * weighted));
  }
  return result;
}

double ProjectedProduct::knownProduct(const VectorXd& left, const VectorXd& right) const {
  return left.dot(whitened(right).col(0));
}

double ProjectedProduct::product(const VectorXd& left, const VectorXd& right) const {
  const VectorXd leftPart = whitenedUnknowns_.transpose() * left, rightPart = whitenedUnknowns_.transpose() * right;
  return knownProduct(left, right) - leftPart.dot(information_.solve(rightPart));
}

} // namespace blind
