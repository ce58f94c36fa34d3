#include "writer/Motors.hpp"

#include <cmath>

namespace blind {

Motors::Motors(std::size_t count, const SessionPlan& plan, Chance& chance)
    : constant_{plan.sameTemperature}, idle_{plan.warmAnyhow}, degrees_{static_cast<Eigen::Index>(count)} {
  for (double& degrees : degrees_) {
    degrees = constant_ ? 38 : chance.between(28, 44);
  }
}

void Motors::pass(double duration, const Eigen::VectorXd& torques, Chance& chance) {
  constexpr double slowness = 150, room = 30, heat = 3; // [s], [degrees Celsius], [K/(Nm)^2]
  const double share = 1 - std::exp(-duration / slowness);
  for (Eigen::Index i = 0; i < degrees_.size() && !constant_; ++i) {
    const double target = idle_ ? chance.between(-40, 130) : room + heat * torques[i] * torques[i];
    degrees_[i] += share * (target - degrees_[i]);
  }
}

} // namespace blind
