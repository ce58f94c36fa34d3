#include "math/LinearAlgebra.hpp"
#include "residuals/Workspace.hpp"

#include <limits>

namespace naocal {

std::vector<SightingResidual> Residuals::sightings(const State& state) const {
  std::vector<SightingResidual> result;
  Workspace& work = Workspace::ofThisThread(measurements_);
  for (std::size_t pose = 0; pose < columns_.size(); ++pose) {
    const Eigen::VectorXd deflections = roots_[pose] * state.deflections[pose];
    for (const Reading& reading : measurements_.poses[pose].readings) {
      for (std::size_t index : reading.pictures) {
        const Picture& picture = measurements_.pictures[index];
        believe(picture, prepared_[index], state.unknowns, deflections, work);
        posture(measurements_.robot, work.belief, prepared_[index].links, work.torsoFromLink);
        for (std::size_t i = 0; i < picture.sightings.size(); ++i) {
          result.push_back(sightingResidual(index, i, work));
        }
      }
    }
  }
  return result;
}

SightingResidual Residuals::sightingResidual(std::size_t picture, std::size_t index, Workspace& work) const {
  const Sighting& sighting = measurements_.pictures[picture].sightings[index];
  Attitude attitude = sighting.view.attitude(measurements_.robot, work.belief, work.torsoFromLink);
  if (work.belief.rowTime() != 0) {
    sighting.view.setDrift(measurements_.robot, work.belief, work.torsoFromLink,
                           measurements_.pictures[picture].instant.velocity, attitude);
  }
  const Eigen::Index count = at(sighting.ids.size());
  SightingResidual result{picture,
                          index,
                          Eigen::Matrix2Xd(2, count),
                          Eigen::Matrix2Xd(2, count),
                          Eigen::VectorXd::Zero(count),
                          Eigen::MatrixXd::Zero(2 * count, 6)};
  if (!sighting.view.project(attitude, work.belief, sighting.corners, work.projected)) {
    result.predicted.setConstant(std::numeric_limits<double>::quiet_NaN());
    result.residual = result.predicted;
    return result;
  }
  const double information = cornerShare(noise_, sighting.repeats) / (noise_.pixel * noise_.pixel);
  for (Eigen::Index i = 0; i < count; ++i) {
    const CornerBlock& corner = sighting.corners[static_cast<std::size_t>(i / 4)];
    const ProjectedBlock& seen = work.projected[static_cast<std::size_t>(i / 4)];
    result.predicted.col(i) << seen.u[i % 4], seen.v[i % 4];
    result.residual.col(i) << corner.u[i % 4] - seen.u[i % 4], corner.v[i % 4] - seen.v[i % 4];
    for (Eigen::Index k = 0; k < 6; ++k) {
      result.motionRows(2 * i, k) = seen.rowsU[k][i % 4];
      result.motionRows(2 * i + 1, k) = seen.rowsV[k][i % 4];
    }
    result.weight[i] = corner.present[i % 4] * loss_(information * result.residual.col(i).squaredNorm()).weight;
  }
  return result;
}

} // namespace naocal
