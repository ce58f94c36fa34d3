#pragma once

#include "writer/RandomStream.hpp"
#include "writer/Session.hpp"

#include <filesystem>

namespace blind {

/// Writes every picture of a session into the folder, as its captures name them: printed sheets with their margins on
/// a grey floor, cell by cell through the true corners' homographies, blurred and noisy.
void renderSession(const Robot& robot, const Session& session, RandomStream& chance,
                   const std::filesystem::path& folder);

} // namespace blind
