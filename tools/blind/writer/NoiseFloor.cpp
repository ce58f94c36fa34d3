#include "writer/NoiseFloor.hpp"

#include "writer/Drawn.hpp"
#include "writer/Jacobian.hpp"
#include "writer/Noncentrality.hpp"

#include <Eigen/QR>
#include <cmath>

namespace blind {

double noiseFloor(const Robot& robot, const Session& session, const SeenCorners& seen) {
  Session asRead = session;
  for (Reading& reading : asRead.readings) {
    reading.unread.setZero();
    reading.stuck.setZero();
  }
  Eigen::VectorXd missing = -Noncentrality::stacked(Pictures{robot, asRead}, asRead);
  Eigen::Index row = 0;
  for (const std::vector<Eigen::Vector2d>& sight : seen) {
    for (const Eigen::Vector2d& corner : sight) {
      missing.segment<2>(row) += corner;
      row += 2;
    }
  }
  const Robot sound = withoutFlaws(robot); // for the derivatives, which flaws hardly change
  const Jacobian jacobian{sound, asRead};
  const Eigen::MatrixXd places = jacobian.unknowns().rightCols(jacobian.placeCount());
  const Eigen::VectorXd left = missing - places * places.colPivHouseholderQr().solve(missing);
  return std::sqrt(left.squaredNorm() / (0.5 * static_cast<double>(left.size())));
}

} // namespace blind
