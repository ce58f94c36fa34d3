#include "evidence/NoiseFloor.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

double noiseFloorPx(const std::vector<PoseSystem>& poses, const Noise& noise) {
  const double corner = noise.pixel * noise.pixel + noise.pixelAlike * noise.pixelAlike;
  double numbers = 0, expected = 0;
  for (const PoseSystem& pose : poses) {
    numbers += pose.numbers;
    const DeflectionRoot root = deflectionRoot(pose, noise);
    expected +=
        corner * pose.numbers + Eigen::MatrixXd{root.transpose() * Eigen::MatrixXd{pose.deflectionGram * root}}.trace();
  }
  return std::sqrt(2 * expected / std::max(1.0, numbers));
}

} // namespace naocal
