#pragma once

#include "simulation/Renderer.hpp"
#include "simulation/Simulation.hpp"

#include <filesystem>
#include <functional>

namespace naocal {

/// What lay before the camera at one capture of a simulation.
RenderedScene sceneAt(const Simulation& simulation, std::size_t capture);

/// Takes the pictures of a simulation whose plan has `images`, `threads` at a time, and writes them into the set's
/// folder under the names that the set gives. `proceed` is told how many are done; when it answers false no more are
/// taken. Returns how many captures, from the first on, have their picture. The same seed gives the same pictures.
std::size_t renderPictures(const Simulation& simulation, const Appearance& appearance, std::uint64_t seed,
                           const std::filesystem::path& setFolder, std::size_t threads,
                           const std::function<bool(std::size_t)>& proceed);

} // namespace naocal
