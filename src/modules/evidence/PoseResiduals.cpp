#include "evidence/PoseResiduals.hpp"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>

namespace naocal {

namespace {

Eigen::MatrixXd normals(Eigen::Index rows, Eigen::Index columns, boost::random::mt19937_64& random) {
  boost::random::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

} // namespace

PoseResiduals measuredResiduals(const std::vector<PoseRows>& poses) {
  PoseResiduals result;
  for (const PoseRows& pose : poses) {
    result.emplace_back(pose.residual);
  }
  return result;
}

PoseResiduals drawnResiduals(const std::vector<PoseRows>& poses, const Noise& noise, Eigen::Index draws,
                             std::uint64_t seed) {
  boost::random::mt19937_64 random{seed};
  PoseResiduals result;
  for (const PoseRows& pose : poses) {
    Eigen::MatrixXd& drawn = result.emplace_back(noise.pixel * normals(pose.residual.size(), draws, random));
    const Eigen::MatrixXd deflections = normals(pose.byDeflections.cols(), draws, random);
    drawn.noalias() += Eigen::MatrixXd{pose.byDeflections * deflectionRoot(pose, noise)} * deflections;
  }
  return result;
}

} // namespace naocal
