#include "poses/Approach.hpp"

#include "math/LinearAlgebra.hpp"

#include <algorithm>

namespace naocal {

Eigen::VectorXd randomApproach(const Robot& robot, std::mt19937_64& random) {
  Eigen::VectorXd result(at(robot.joints.size()));
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const double drawn = random() % 2 == 0 ? 1 : -1;
    const std::size_t motor = robot.joints[joint].motor;
    result[at(joint)] = motor < joint ? result[at(motor)] : drawn;
  }
  return result;
}

bool looksAtApproach(const Model& model) {
  return std::any_of(model.terms().begin(), model.terms().end(), [](const Term& term) {
    const auto& needs = term.effect.needs;
    return std::find(needs.begin(), needs.end(), Driver::approach) != needs.end();
  });
}

} // namespace naocal
