#include "calibrate/Doubts.hpp"

#include "calibrate/Fit.hpp"

#include <cmath>

namespace naocal {

std::vector<Doubt> doubts(const Measurements& measurements, const CalibrationResult& result) {
  std::vector<Doubt> all;
  for (const SightingResidual& seen : result.sightings) {
    const Sighting& sighting = measurements.pictures[seen.picture].sightings[seen.sighting];
    Doubt doubt{seen.picture, seen.sighting, {}, false, 0};
    double squares = 0;
    for (Eigen::Index i = 0; i < seen.weight.size(); ++i) {
      if (seen.weight[i] < trusted) {
        doubt.corners.push_back(sighting.ids[static_cast<std::size_t>(i)]);
        squares += seen.residual.col(i).squaredNorm();
      }
    }
    if (!doubt.corners.empty()) {
      doubt.distance = std::sqrt(squares / static_cast<double>(doubt.corners.size()));
      doubt.whole = hasLostWeight(seen);
      all.push_back(std::move(doubt));
    }
  }
  return all;
}

Accidents::Accidents(const Measurements& measurements, const std::vector<Doubt>& doubts) {
  for (const Picture& picture : measurements.pictures) {
    all += picture.sightings.size();
  }
  for (const Doubt& doubt : doubts) {
    moved += doubt.whole ? 1 : 0;
  }
}

std::size_t Accidents::mostSetAside() const {
  constexpr double share = 0.1;
  return static_cast<std::size_t>(std::ceil(share * static_cast<double>(all)));
}

} // namespace naocal
