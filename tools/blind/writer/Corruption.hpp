#pragma once

#include "writer/SessionPlanner.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace blind {

/// Effects that the poses cannot test: what makes them so is planned into the session.
const std::vector<std::string>& absorbedKinds();

/// Mistakes of people and wiring. Each changes the finished set, but for what moves during the session.
const std::vector<std::string>& corruptions();

/// What happens once, at a time: a kicked board, a foot that slips, a joint whose offset steps.
const std::vector<std::string>& eventKinds();

/// A kicked board or a robot that slips: decided before the pictures are taken.
void corruptSession(const std::string& kind, Session& session, RandomStream& chance);
/// Everything else: done to the capture set's JSON. Returns what was done, for the truth.
std::string corruptFile(const std::string& kind, int side, nlohmann::json& set, RandomStream& chance);

} // namespace blind
