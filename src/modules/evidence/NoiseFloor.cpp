#include "evidence/NoiseFloor.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

double noiseFloorPx(const std::vector<PoseRows>& poses, const Noise& noise) {
  const double corner = noise.pixel * noise.pixel + noise.pixelAlike * noise.pixelAlike;
  double numbers = 0, expected = 0;
  for (const PoseRows& pose : poses) {
    numbers += pose.numbers;
    const Eigen::MatrixXd moved = pose.byDeflections * deflectionRoot(pose, noise);
    expected += corner * pose.numbers + moved.squaredNorm();
  }
  return std::sqrt(2 * expected / std::max(1.0, numbers));
}

} // namespace naocal
