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

/// Live view of a robot for panels: its outline, the visible floor, detected and predicted corners. A separate thread
/// detects corners in the newest image of each camera, a few times per second.
class LiveDetection {
public:
  /// Receives messages for panels: {"kind": "scene" | "seen", ..}. "seen" comes from the detection thread.
  using MessageSink = std::function<void(std::string json)>;
  LiveDetection(std::string robot, MessageSink tell);
  ~LiveDetection();

  /// Keys it needs subscriptions to.
  static constexpr std::array<std::string_view, 4> keys{
      "Motion.angles", "Brain.cameras", "Brain.CameraCalibration.top_image", "Brain.CameraCalibration.bottom_image"};
  /// The camera of an image key: "top", "bottom"; empty for other keys.
  static std::string cameraOf(std::string_view key);
  static constexpr std::string_view boardsMount = "Brain.CalibrationRunner",
                                    offsetsMount = "Motion.JointCalibrationProvider";

  void onUpdate(const nlohmann::json& update); // {"key", "timestamp", "value"}
  void onImage(const std::string& key, std::uint64_t timestamp, int width, int height, std::string_view file);
  void onConfiguration(const nlohmann::json& settings); // of `boardsMount`: [{"key", "value"}]
  void onOffsets(const nlohmann::json& offsets);        // of `offsetsMount`: [{"key", "value"}]

private:
  struct SharedScene;
  void tellScene();

  std::string robot_;
  MessageSink tell_;
  Robot drawing_;
  LiveCameras cameras_;
  nlohmann::json offsets_;                          // last received
  std::string camerasText_;                         // JSON text of `cameras_`
  std::map<std::uint64_t, Eigen::VectorXd> angles_; // recent joint angles by time [ms]
  std::chrono::steady_clock::time_point told_;
  std::map<std::string, std::chrono::steady_clock::time_point> looked_; // last detection, by camera
  std::shared_ptr<SharedScene> sight_;                                 // shared with the thread
  Worker worker_{Worker::AtEnd::presentTask};                           // last: uses the members above
};

} // namespace naocal
