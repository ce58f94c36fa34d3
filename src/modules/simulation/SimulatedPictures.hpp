#pragma once

#include "simulation/Renderer.hpp"
#include "simulation/Simulation.hpp"

#include <filesystem>
#include <functional>

namespace naocal {

/// Renders the images of a simulation whose plan has `images`, `threads` at a time, and writes them into the set's
/// folder under the captures' names. Calls `proceed` with the number done; stops when it returns false. Returns the
/// number of leading captures with an image. Reproducible by seed. Throws InputError if it cannot write.
std::size_t renderPictures(const Simulation& simulation, const Appearance& appearance, std::uint64_t seed,
                           const std::filesystem::path& setFolder, std::size_t threads,
                           const std::function<bool(std::size_t)>& proceed);

} // namespace naocal
