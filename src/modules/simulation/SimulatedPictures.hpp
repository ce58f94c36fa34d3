#pragma once

#include "simulation/Renderer.hpp"
#include "simulation/Simulation.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace naocal {

/// What a simulation's pictures show.
struct PictureSource {
  const CaptureSet& set; // captures that name an image have a picture
  const std::map<std::string, CameraIntrinsics>& lenses;
  std::function<RenderedScene(std::size_t capture)> sceneAt;
};

/// Of a NAO's simulation whose plan has `images`; must not outlive it.
PictureSource picturesOf(const Simulation& simulation);
PictureSource picturesOf(Simulation&&) = delete;

/// Renders the images of a simulation, `threads` at a time, and writes them into the set's folder under the captures'
/// names. Calls `proceed` with the number of captures done; stops when it returns false. Returns the number of leading
/// captures that are done. Reproducible by seed. Throws InputError if it cannot write.
std::size_t renderPictures(const PictureSource& source, const Appearance& appearance, std::uint64_t seed,
                           const std::filesystem::path& setFolder, std::size_t threads,
                           const std::function<bool(std::size_t)>& proceed);

} // namespace naocal
