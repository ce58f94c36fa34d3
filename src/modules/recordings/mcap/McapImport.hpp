#pragma once

#include "recordings/ImportScene.hpp"
#include "recordings/RestInstants.hpp"

#include <filesystem>
#include <string>

namespace naocal {

/// The topics of a recording that make captures.
struct McapTopics {
  std::string joints = "/joint_states"; // sensor_msgs/msg/JointState
  std::string images;                   // sensor_msgs/msg/Image or CompressedImage
  std::string cameraInfo;               // sensor_msgs/msg/CameraInfo; empty: "camera_info" beside `images`
};

/// A set made of a recording, and what it was made of.
struct McapImport {
  ImportedSet imported;
  std::size_t pictures = 0, rests = 0, poses = 0;
};

/// One capture for each rest of the robot (`findRestInstants`), with its picture. The camera's link is the scene's, or
/// else the frame of its messages; the lens is the scene's, or else that of CameraInfo. Reads the recording twice, and
/// keeps only the chosen pictures in memory.
///
/// Throws InputError: what the readers refuse, topics without messages of these types (lists those there are), no
/// joint of the robot, no rest.
McapImport importMcap(const std::filesystem::path& file, const ImportScene& scene, const McapTopics& topics,
                      const RestOptions& rests);

} // namespace naocal
