#pragma once

#include "writer/Pictures.hpp"

namespace blind {

/// How many corners a camera would find.
double cornersInView(const Skeleton& skeleton, const Stance& stance, int camera, const std::vector<FloorPlace>& boards,
                     const Eigen::VectorXd& angles);

/// Every board in every picture, with the corners that a detector would find there.
std::vector<Sight> allSights(const Pictures& pictures, const Session& session);

/// How much worse corners are for the board's slant: sqrt((1 + 1 / cosine^2) / 2) of the angle to its normal.
double slantFactor(const Pictures& pictures, const Session& session, const Sight& sight);

} // namespace blind
