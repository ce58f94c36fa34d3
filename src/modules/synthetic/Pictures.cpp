#include "synthetic/Pictures.hpp"

#include "captures/InputError.hpp"

#include <fmt/format.h>

namespace naocal {

namespace {

void makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw InputError{fmt::format("{}: the folder cannot be made: {}", folder.string(), error.message())};
  }
}

} // namespace

RenderedScene sceneBefore(const Simulation& simulation, std::size_t capture) {
  Eigen::Matrix3d opticalFromCamera; // x right, y down, z forward from x forward, y left, z up
  opticalFromCamera << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  const Exposure& exposure = simulation.exposures[capture];
  RenderedScene scene;
  for (std::size_t board = 0; board < simulation.set.boards.size(); ++board) {
    const Eigen::Isometry3d opticalFromBoard =
        opticalFromCamera * (exposure.worldFromCamera.inverse() * exposure.worldFromBoard[board]);
    scene.boards.push_back({simulation.set.boards[board].id,
                            *simulation.set.boards[board].pattern,
                            {opticalFromBoard.linear(), opticalFromBoard.translation()}});
  }
  return scene;
}

void takePictures(const Simulation& simulation, const Appearance& appearance, std::uint64_t seed,
                  const std::filesystem::path& setFolder, const std::function<bool(std::size_t)>& taken) {
  std::map<std::string, Renderer> renderers;
  for (const auto& [name, intrinsics] : simulation.set.cameras) {
    renderers.emplace(name, intrinsics);
  }
  makeFolder(setFolder / "images");
  for (std::size_t i = 0; i < simulation.set.captures.size(); ++i) {
    const Capture& capture = simulation.set.captures[i];
    const GreyPicture picture =
        renderers.at(capture.camera).picture(sceneBefore(simulation, i), appearance, seed ^ (i << 32U));
    writePicture(picture, setFolder / capture.image);
    if (!taken(i + 1)) {
      return;
    }
  }
}

} // namespace naocal
