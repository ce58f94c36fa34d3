#pragma once

#include "world/RandomStream.hpp"
#include "world/machines/Machine.hpp"

#include <functional>
#include <optional>

namespace blind {

/// What a posture misses; zero where it is reached [m, rad].
using Miss = std::function<Eigen::VectorXd(const MachineBody::Posture&)>;

/// Angles within the joints' limits that reach a goal, from a start, by damped least squares. Absent if there are none.
std::optional<Eigen::VectorXd> reach(const Machine& machine, const MachineBody& body, Eigen::VectorXd start,
                                     const Miss& miss);

/// Uniform within the joints' limits.
Eigen::VectorXd drawAngles(const Machine& machine, RandomStream& chance);

} // namespace blind
