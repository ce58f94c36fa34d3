#pragma once

#include "writer/Chance.hpp"
#include "writer/Session.hpp"

namespace blind {

/// The joints that move a camera over the standing sole: head and standing leg, hip yaw-pitch by its motor's name.
std::vector<int> chainOf(const Drawing& drawing, int side);

/// Places of A2 boards round the robot on which no two overlap.
std::vector<FloorPlace> layOut(int boards, Chance& chance);

} // namespace blind
