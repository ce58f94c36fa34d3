#include "evidence/PoseScores.hpp"

#include "geometry/InParallel.hpp"

#include <Eigen/Cholesky>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <utility>

namespace naocal {

namespace {

Eigen::MatrixXd normals(Eigen::Index rows, Eigen::Index columns, boost::random::mt19937_64& random) {
  boost::random::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

/// F F^T = `gram`, which may be singular. Columns come in all units, so they are brought to one scale; there as small a
/// part is added as lets the factorisation succeed, far less than any candidate that can be tested keeps.
Eigen::MatrixXd rootOf(const Eigen::MatrixXd& gram) {
  const Eigen::VectorXd unit = gram.diagonal().cwiseMax(1e-300).cwiseSqrt();
  const Eigen::VectorXd inverse = unit.cwiseInverse();
  const Eigen::MatrixXd scaled = inverse.asDiagonal() * gram * inverse.asDiagonal();
  for (double added = 1e-12;; added *= 10) {
    Eigen::MatrixXd regular = scaled;
    regular.diagonal().array() += added;
    if (const Eigen::LLT<Eigen::MatrixXd> factor{regular}; factor.info() == Eigen::Success) {
      return unit.asDiagonal() * Eigen::MatrixXd{factor.matrixL()};
    }
  }
}

} // namespace

PoseScores measuredScores(const Residuals::Linear& linear, const Noise& noise) {
  const double information = 1 / (noise.pixel * noise.pixel);
  PoseScores result;
  for (const PoseSystem& pose : linear.poses) {
    result.push_back({information * pose.unknownGradient, information * pose.deflectionGradient});
  }
  return result;
}

PoseScores drawnScores(const Residuals::Linear& linear, const Noise& noise, Eigen::Index draws, std::uint64_t seed) {
  boost::random::mt19937_64 random{seed};
  std::vector<std::pair<Eigen::MatrixXd, Eigen::MatrixXd>> chance; // per pose, of its corners and of its deflections
  for (const PoseSystem& pose : linear.poses) {
    const Eigen::Index unknowns = pose.unknownGradient.size(), joints = pose.deflectionGradient.size();
    Eigen::MatrixXd corners = normals(unknowns + joints, draws, random);
    chance.emplace_back(std::move(corners), normals(joints, draws, random));
  }
  const double information = 1 / (noise.pixel * noise.pixel);
  PoseScores result(linear.poses.size());
  inParallel(result.size(), [&](std::size_t i) {
    const PoseSystem& pose = linear.poses[i];
    const Eigen::Index unknowns = pose.unknownGradient.size(), joints = pose.deflectionGradient.size();
    Eigen::MatrixXd gram(unknowns + joints, unknowns + joints);
    gram << pose.unknownGram, pose.cross, pose.cross.transpose(), pose.deflectionGram;
    gram *= information;
    Eigen::MatrixXd scores = rootOf(gram) * chance[i].first;
    if (joints > 0) {
      scores += gram.rightCols(joints) * (deflectionRoot(pose, noise) * chance[i].second);
    }
    result[i] = {scores.topRows(unknowns), scores.bottomRows(joints)};
  });
  return result;
}

} // namespace naocal
