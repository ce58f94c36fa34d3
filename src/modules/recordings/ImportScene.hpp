#pragma once

#include "data/Capture.hpp"
#include "robot/Robot.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// What a recording says nothing of: the robot, the camera's lens and mount, the boards.
struct ImportScene {
  std::string urdf; // text of the robot's URDF
  Robot robot;      // parsed from it
  std::string camera = "camera";
  std::optional<CameraIntrinsics> lens; // absent: the recording's own
  std::string cameraLink;               // of the URDF, or "world": it stands beside the robot; empty: unknown
  std::vector<Board> boards;            // with their links
};

/// Where a scene is read from, as the options of `naocal import` give it.
struct SceneSources {
  std::string robot;               // file of the URDF
  std::string camera = "camera";   // its name in the set
  std::string cameraModel;         // file of the lens; empty: none
  std::string cameraLink;          // as in ImportScene
  std::string boards;              // file of the boards; empty: none
  std::string boardLink = "world"; // link that carries the boards, "world" or "floor"
};

/// Reads a scene. Throws InputError with file or option, expected and found: as the readers of URDFs, lenses and boards
/// do, and for a link of boards that the URDF does not have.
ImportScene readImportScene(const SceneSources& sources);

/// Throws InputError, which says how to give them, without boards in the scene: pictures are of boards.
void requireBoards(const ImportScene& scene);

/// An imported set, and the files beside its captures.json.
struct ImportedSet {
  CaptureSet set;
  // By path within the set's folder:
  std::map<std::string, std::string> files;            // content
  std::map<std::string, std::filesystem::path> copies; // file to copy
};

/// A set without captures: robot, recorded joints, boards, and one stance in which the base stands in the world.
/// Version 2; its URDF is "robot.urdf".
ImportedSet beginImport(const ImportScene& scene, std::vector<std::string> jointNames);

/// Adds the scene's camera. Throws InputError without a lens or a link; `remedy` says how to give one.
void addCamera(const ImportScene& scene, const std::optional<CameraIntrinsics>& lens, const std::string& link,
               ImportedSet& imported);

/// Writes the files, then captures.json, into a folder. Throws InputError if the folder exists and is not empty.
void writeImport(const ImportedSet& imported, const std::filesystem::path& folder);

/// The name of pose number `index`: "P0007".
std::string poseName(std::size_t index);

} // namespace naocal
