#pragma once

#include "math/Worker.hpp"
#include "robot/FloorScene.hpp"
#include "robot/LiveExpectation.hpp"

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace naocal {

/// Looks over a robot's shoulder while some panel wants that: how it stands, what its cameras see of the floor, where
/// corners are in its pictures and where they should be. Corners are found by a thread of its own, in the newest
/// picture of a camera only, a few times a second.
class LiveDetection {
public:
  /// A message for panels: {"kind": "scene" | "seen", ..}. "seen" comes from the watch's own thread.
  using MessageSink = std::function<void(std::string json)>;
  LiveDetection(std::string robot, MessageSink tell);
  ~LiveDetection();

  /// What it wants to be told of.
  static constexpr std::array<std::string_view, 4> keys{
      "Motion.angles", "Brain.cameras", "Brain.CameraCalibration.top_image", "Brain.CameraCalibration.bottom_image"};
  /// Which of them is a camera's picture: "top", "bottom"; empty: none.
  static std::string cameraOf(std::string_view key);
  static constexpr std::string_view boardsMount = "Brain.CalibrationRunner",
                                    offsetsMount = "Motion.JointCalibrationProvider";

  void onUpdate(const nlohmann::json& update); // {"key", "timestamp", "value"}
  void onImage(const std::string& key, std::uint64_t timestamp, int width, int height, std::string_view file);
  void onConfiguration(const nlohmann::json& settings); // of `boardsMount`: [{"key", "value"}]
  void onOffsets(const nlohmann::json& offsets);        // of `offsetsMount`, alike

private:
  struct VisibleBoard;
  void tellScene();

  std::string robot_;
  MessageSink tell_;
  Robot drawing_;
  LiveCameras cameras_;
  nlohmann::json offsets_;                          // as they were last told
  std::string camerasText_;                         // that they were told by
  std::map<std::uint64_t, Eigen::VectorXd> angles_; // of the last seconds, by time [ms]
  std::chrono::steady_clock::time_point told_;
  std::map<std::string, std::chrono::steady_clock::time_point> looked_; // by camera
  std::shared_ptr<VisibleBoard> sight_;                                 // shared with the thread
  Worker worker_{Worker::AtEnd::presentTask};                           // last: it uses the others
};

} // namespace naocal
