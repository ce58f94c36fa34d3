#include "simulation/SimulatedPictures.hpp"

#include "io/GreyImage.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <future>

namespace naocal {

namespace {

void makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw InputError{fmt::format("{}: the folder cannot be made: {}", folder.string(), error.message())};
  }
}

/// The scene in front of the camera at one capture of a simulation.
RenderedScene sceneAt(const Simulation& simulation, std::size_t capture) {
  const Exposure& exposure = simulation.exposures[capture];
  RenderedScene scene;
  for (std::size_t board = 0; board < simulation.set.boards.size(); ++board) {
    const Eigen::Isometry3d opticalFromBoard =
        opticalFromCamera() * (exposure.worldFromCamera.inverse() * exposure.worldFromBoard[board]);
    scene.boards.push_back({simulation.set.boards[board].id,
                            *simulation.set.boards[board].pattern,
                            {opticalFromBoard.linear(), opticalFromBoard.translation()}});
  }
  return scene;
}

} // namespace

PictureSource picturesOf(const Simulation& simulation) {
  return {simulation.set, simulation.set.cameras, [&](std::size_t capture) { return sceneAt(simulation, capture); }};
}

std::size_t renderPictures(const PictureSource& source, const Appearance& appearance, std::uint64_t seed,
                           const std::filesystem::path& setFolder, std::size_t threads,
                           const std::function<bool(std::size_t)>& proceed) {
  std::map<std::string, Renderer> renderers;
  for (const auto& [name, intrinsics] : source.lenses) {
    renderers.emplace(name, intrinsics);
  }
  const std::vector<Capture>& captures = source.set.captures;
  const auto take = [&](std::size_t i) {
    if (!captures[i].image.empty()) {
      const GreyPicture picture =
          renderers.at(captures[i].camera).render(source.sceneAt(i), appearance, seed ^ (std::uint64_t{i} << 32U));
      writeImage(picture, setFolder / captures[i].image);
    }
  };
  makeFolder(setFolder / "images");
  std::size_t done = 0;
  for (bool going = true; going && done < captures.size(); going = proceed(done)) {
    std::vector<std::future<void>> together;
    for (const std::size_t end = std::min(done + threads, captures.size()); done < end; ++done) {
      together.push_back(std::async(std::launch::async, take, done));
    }
    for (std::future<void>& picture : together) {
      picture.get();
    }
  }
  return done;
}

} // namespace naocal
