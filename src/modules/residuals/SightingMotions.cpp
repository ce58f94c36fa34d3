#include "math/LinearAlgebra.hpp"
#include "residuals/Workspace.hpp"

#include <algorithm>

namespace naocal {

std::optional<std::vector<SightingMotion>> Residuals::sightingMotions(const State& state) const {
  std::vector<SightingMotion> result;
  Workspace& work = Workspace::ofThisThread(measurements_);
  for (std::size_t pose = 0; pose < columns_.size(); ++pose) {
    const Eigen::VectorXd deflections = roots_[pose] * state.deflections[pose];
    const Eigen::Index columns = at(columns_[pose].unknowns.size() + columns_[pose].joints.size());
    for (const Reading& reading : measurements_.poses[pose].readings) {
      for (std::size_t index : reading.pictures) {
        const Picture& picture = measurements_.pictures[index];
        believe(picture, prepared_[index], state.unknowns, deflections, work);
        posture(measurements_.robot, work.belief, prepared_[index].links, work.torsoFromLink);
        for (const PreparedPicture::Group& group : prepared_[index].groups) {
          for (std::size_t sighting : group.sightings) {
            SightingMotion motion{.picture = index, .sighting = sighting, .pose = pose};
            motion.cross.setZero(6, columns);
            if (!addMotion(picture.sightings[sighting], group, work, motion)) {
              return std::nullopt;
            }
            result.push_back(std::move(motion));
          }
        }
      }
    }
  }
  return result;
}

/// Fills in a sighting's sums. False: a corner is nowhere.
bool Residuals::addMotion(const Sighting& sighting, const PreparedPicture::Group& group, Workspace& work,
                          SightingMotion& motion) const {
  Attitude attitude = sighting.view.pathAttitude(measurements_.robot, work.belief, work.torsoFromLink);
  if (std::find(group.extras.begin(), group.extras.end(), rowTimeExtra) != group.extras.end()) {
    sighting.view.setDrift(measurements_.robot, work.belief, work.torsoFromLink,
                           measurements_.pictures[motion.picture].instant.velocity, attitude);
  }
  work.corners.clear(group.extras.size());
  if (!addCorners(sighting, group.extras, attitude, work)) {
    return false;
  }
  work.motion.resize(at(6 + group.extras.size()), at(group.quantities.size()));
  sighting.view.motion(measurements_.robot, attitude, work.belief, work.torsoFromLink, group.quantities, group.extras,
                       work.motion);
  const PictureGram::Square gram = work.corners.gram();
  motion.gram = gram.topLeftCorner<6, 6>();
  motion.gradient = work.corners.gradient().head<6>();
  const Eigen::MatrixXd byQuantities = gram.topRows<6>() * work.motion;
  for (const PreparedPicture::Group::Share& share : group.shares) {
    motion.cross.col(group.columns[share.column]) += work.slopes[share.slope] * byQuantities.col(share.quantity);
  }
  return true;
}

} // namespace naocal
