#pragma once

#include "world/RandomStream.hpp"
#include "world/Session.hpp"

#include <filesystem>

namespace blind {

/// Renders every image of a session into the folder, under its captures' names: printed sheets with margins on a grey
/// floor, cell by cell through homographies of the true corners, with blur and noise.
void renderSession(const Robot& robot, const Session& session, RandomStream& chance,
                   const std::filesystem::path& folder);

} // namespace blind
