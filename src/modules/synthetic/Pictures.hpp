#pragma once

#include "synthetic/Rendering.hpp"
#include "synthetic/Simulation.hpp"

#include <filesystem>
#include <functional>

namespace naocal {

/// What lay before the camera at one capture of a simulation.
RenderedScene sceneBefore(const Simulation& simulation, std::size_t capture);

/// Takes the pictures of a simulation whose plan has `images` and writes them into the set's folder under the names
/// that the set gives. `taken` is told after each how many there are; when it returns false no more are taken.
/// The same seed gives the same pictures.
void takePictures(const Simulation& simulation, const Appearance& appearance, std::uint64_t seed,
                  const std::filesystem::path& setFolder, const std::function<bool(std::size_t)>& taken);

} // namespace naocal
