#pragma once

#include "writer/SessionPlanner.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace blind {

/// Effects that the poses cannot test; the session is planned accordingly.
const std::vector<std::string>& absorbedKinds();

/// Human and wiring mistakes. Each modifies the finished set, except displacements during the session.
const std::vector<std::string>& corruptions();

/// Events at one time: a kicked board, a slipping foot, a step of a joint offset.
const std::vector<std::string>& eventKinds();

/// A kicked board or slipped robot; must be called before corners are simulated.
void corruptSession(const std::string& kind, Session& session, RandomStream& chance);
/// All other corruptions: modifies the capture set's JSON. Returns a description for the truth.
std::string corruptFile(const std::string& kind, int side, nlohmann::json& set, RandomStream& chance);

} // namespace blind
