#include "recordings/ImportScene.hpp"

#include "data/BoardListFile.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "recordings/CameraModelFile.hpp"
#include "robot/Urdf.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace naocal {

namespace {

const std::string urdfName = "robot.urdf";

std::vector<std::string> linkNames(const Robot& robot) {
  std::vector<std::string> names;
  for (const Link& link : robot.links) {
    names.push_back(link.name);
  }
  return names;
}

} // namespace

ImportScene readImportScene(const SceneSources& sources) {
  ImportScene scene;
  scene.urdf = readUrdf(sources.robot);
  scene.robot = parseUrdf(scene.urdf, sources.robot);
  scene.camera = sources.camera;
  scene.cameraLink = sources.cameraLink;
  if (!sources.cameraModel.empty()) {
    scene.lens = readCameraModel(sources.cameraModel);
  }
  const bool isLink = sources.boardLink == "world" || sources.boardLink == "floor" ||
                      scene.robot.linkIndex(sources.boardLink).has_value();
  if (!isLink) {
    throw InputError{fmt::format("--board-link: expected \"world\", \"floor\" or a link of {}, found \"{}\"",
                                 sources.robot, printableText(sources.boardLink, 80))};
  }
  if (!sources.boards.empty()) {
    scene.boards = readBoards(sources.boards);
    for (Board& board : scene.boards) {
      board.link = sources.boardLink;
    }
  }
  return scene;
}

void requireBoards(const ImportScene& scene) {
  if (scene.boards.empty()) {
    throw InputError{"--boards: expected a file with the boards in the pictures, found none; naocal board writes one, "
                     "and a board to print"};
  }
}

ImportedSet beginImport(const ImportScene& scene, std::vector<std::string> jointNames) {
  ImportedSet imported;
  imported.files[urdfName] = scene.urdf;
  CaptureSet& set = imported.set;
  set.version = 2;
  set.model.clear();
  set.urdf = urdfName;
  set.jointNames = std::move(jointNames);
  set.boards = scene.boards;
  Stance stance;
  stance.supportFoot = SupportFoot::none;
  set.stances = {stance};
  return imported;
}

void addCamera(const ImportScene& scene, const std::optional<CameraIntrinsics>& lens, const std::string& link,
               ImportedSet& imported) {
  if (!lens) {
    throw InputError{"import: expected a lens of the camera, found none; give its calibration with --camera-model "
                     "(OpenCV's YAML, JSON or XML, ROS's camera_info, kalibr's camchain, mrcal's cameramodel)"};
  }
  if (link != "world" && !scene.robot.linkIndex(link)) {
    const std::vector<std::string> names = linkNames(scene.robot);
    throw InputError{fmt::format(
        "import: expected the link of the URDF that carries the camera, found \"{}\"; give it with --camera-link: one "
        "of {}, or \"world\" for a camera beside the robot",
        printableText(link, 80), fmt::join(closestNames(link, names, 8), ", "))};
  }
  CameraMounting mounting;
  mounting.link = link;
  imported.set.cameras[scene.camera] = *lens;
  imported.set.mountings[scene.camera] = mounting;
}

void writeImport(const ImportedSet& imported, const std::filesystem::path& folder) {
  if (std::filesystem::exists(folder) &&
      (!std::filesystem::is_directory(folder) || !std::filesystem::is_empty(folder))) {
    throw InputError{
        fmt::format("{}: expected a new or an empty folder for the set, found one with files", folder.string())};
  }
  const auto write = [&](const std::string& path, const std::string& content) {
    std::filesystem::create_directories((folder / path).parent_path());
    writeAtomically(folder / path, content);
  };
  for (const auto& [path, content] : imported.files) {
    write(path, content);
  }
  for (const auto& [path, source] : imported.copies) {
    write(path, readFile(source));
  }
  writeCaptureSet(imported.set, folder);
}

std::string poseName(std::size_t index) {
  return fmt::format("P{:04}", index);
}

} // namespace naocal
