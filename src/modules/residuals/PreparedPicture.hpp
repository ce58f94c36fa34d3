#pragma once

#include "residuals/Measurements.hpp"
#include "residuals/Slopes.hpp"

#include <cstddef>
#include <vector>

namespace naocal {

/// What a picture's residuals need that stays while the slopes do: links to walk, and which quantities move what in the
/// normal equations of its pose. Their columns are the pose's unknowns, then the deflections of its joints.
struct PreparedPicture {
  /// Sightings that the same quantities move in the same way: their corners are summed up together.
  struct Group {
    std::vector<std::size_t> sightings;
    std::vector<std::size_t> quantities;
    std::vector<std::size_t> extras;   // among the quantities (`View::extra`)
    std::vector<Eigen::Index> columns; // that move them
    struct Share {
      Eigen::Index column, quantity; // places in the two lists above
      std::size_t slope;             // of d(quantity)/d(column), in `slopeValues`
    };
    std::vector<Share> shares;
  };
  std::vector<std::size_t> links;
  std::vector<std::size_t> joints;      // between camera and boards, that have a deflection
  std::vector<std::size_t> deflections; // theirs, among the pose's
  PictureSlopes slopes;
  std::vector<double> slopeValues; // 1 for a joint by its deflection, then the slopes
  std::vector<Group> groups;
  Group floor;               // what moves the other sole, where the robot stands on both
  std::optional<View> torso; // over the floor, where the inertial unit tells of it and its tilt is an unknown
  Group imu;                 // what moves the torso, and the unit in it
};

/// Finds links, groups and slope values, given joints, deflections and slopes. `unknowns`: of the picture's pose,
/// ascending.
void prepare(const Measurements& measurements, const Picture& picture, const std::vector<std::size_t>& unknowns,
             PreparedPicture& prepared);

} // namespace naocal
