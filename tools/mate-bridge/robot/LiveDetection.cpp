#include "robot/LiveDetection.hpp"

#include "protocol/BoundedJson.hpp"

#include "data/BoardFile.hpp"
#include "detect/BoardDetector.hpp"
#include "io/GreyImage.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"

#include <mutex>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;
using SteadyClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds betweenScenes{100}, betweenLooks{250};
constexpr std::uint64_t remembered = 2000; // joint angles kept [ms]

LiveCameras camerasOf(const Json& value) {
  LiveCameras cameras;
  for (const auto& [name, camera] : value.items()) {
    LiveCamera& made = cameras[name];
    made.intrinsics.fx = camera.at("fc").at(0);
    made.intrinsics.fy = camera.at("fc").at(1);
    made.intrinsics.cx = camera.at("cc").at(0);
    made.intrinsics.cy = camera.at("cc").at(1);
    for (int axis = 0; axis < 3; ++axis) {
      made.rotation[axis] = camera.at("ext").at(static_cast<std::size_t>(axis));
    }
  }
  return cameras;
}

/// Scales intrinsics to another image size.
CameraIntrinsics scaled(CameraIntrinsics lens, int width, int height) {
  const double factor = double(width) / lens.width;
  lens.fx *= factor;
  lens.fy *= factor;
  lens.cx = (lens.cx + 0.5) * factor - 0.5;
  lens.cy = (lens.cy + 0.5) * factor - 0.5;
  lens.width = width;
  lens.height = height;
  return lens;
}

Json listOf(const std::vector<Eigen::Vector2d>& pixels) {
  Json list = Json::array();
  for (const Eigen::Vector2d& pixel : pixels) {
    list.push_back(std::round(100 * pixel.x()) / 100);
    list.push_back(std::round(100 * pixel.y()) / 100);
  }
  return list;
}

} // namespace

/// State shared with the detection thread.
struct LiveDetection::SharedScene {
  std::mutex mutex;
  std::vector<Board> boards;
  FloorBoardTracker places{{}};
  std::map<std::string, bool> busy; // by camera

  /// Marks a camera as busy; false if it is already, or no boards are known.
  bool begin(const std::string& camera) {
    const std::lock_guard lock{mutex};
    if (boards.empty() || busy[camera]) {
      return false;
    }
    return busy[camera] = true;
  }
  void end(const std::string& camera) {
    const std::lock_guard lock{mutex};
    busy[camera] = false;
  }

  /// Detects boards in an image and tracks them: [{"board", "measured", "predicted"}]. Appends the detected corners to
  /// `corners` [px].
  Json detect(const std::string& image, const CameraView& eye, std::vector<Eigen::Vector2d>& corners) {
    Json list = Json::array();
    try {
      std::unique_lock lock{mutex};
      const std::vector<Board> described = boards;
      lock.unlock();
      for (const BoardCorners& seen :
           detectBoards(decodeImage(image, "a live picture", PictureSize{eye.lens.width, eye.lens.height}), described,
                        eye.lens)
               .boards) {
        lock.lock();
        const auto predicted = places.update(seen, eye);
        lock.unlock();
        corners.insert(corners.end(), seen.uv.begin(), seen.uv.end());
        list.push_back({{"board", seen.board}, {"measured", listOf(seen.uv)}, {"predicted", listOf(predicted)}});
      }
    } catch (const std::exception&) { // ignores a truncated or invalid image
    }
    return list;
  }
};

LiveDetection::LiveDetection(std::string robot, MessageSink tell)
    : robot_{std::move(robot)}, tell_{std::move(tell)}, drawing_{loadRobot(configurationDirectory(), "V6")},
      sight_{std::make_shared<SharedScene>()} {}

LiveDetection::~LiveDetection() = default;

void LiveDetection::onUpdate(const Json& update) {
  const Json& value = update.at("value");
  if (update.at("key") == keys[1]) {
    if (jsonText(value) != camerasText_) { // calibration changed: board poses are outdated
      camerasText_ = jsonText(value);
      cameras_ = camerasOf(value);
      const std::lock_guard lock{sight_->mutex};
      sight_->places = FloorBoardTracker{sight_->boards};
    }
  } else if (auto angles = parseOrderedAngles(value, drawing_)) {
    const std::uint64_t now = update.at("timestamp").get<std::uint64_t>();
    if (!angles_.empty() && now + remembered < angles_.rbegin()->first) {
      angles_.clear(); // the robot was restarted
    }
    angles_[now] = std::move(*angles);
    angles_.erase(angles_.begin(), angles_.lower_bound(now < remembered ? 0 : now - remembered));
    tellScene();
  }
}

void LiveDetection::tellScene() {
  const auto now = SteadyClock::now();
  if (now - told_ < betweenScenes) {
    return;
  }
  told_ = now;
  Json scene = RobotOutline{drawing_, angles_.rbegin()->second}.toJson(cameras_);
  {
    const std::lock_guard lock{sight_->mutex};
    scene["boards"] = sight_->places.toJson();
  }
  scene["kind"] = "scene";
  scene["robot"] = robot_;
  tell_(jsonText(scene));
}

void LiveDetection::onImage(const std::string& key, std::uint64_t timestamp, int width, int height,
                            std::string_view file) {
  const std::string camera = cameraOf(key);
  const auto modelState = cameras_.find(camera);
  const auto now = SteadyClock::now();
  if (angles_.empty() || modelState == cameras_.end() || now - looked_[camera] < betweenLooks) {
    return;
  }
  const auto after = angles_.lower_bound(timestamp);
  const Eigen::VectorXd& angles = after == angles_.end() ? angles_.rbegin()->second : after->second;
  const auto floorFromOptical = RobotOutline{drawing_, angles}.floorFromOptical(camera, modelState->second);
  if (!floorFromOptical) {
    return;
  }
  const CameraView eye{*floorFromOptical, scaled(modelState->second.intrinsics, width, height)};
  if (!sight_->begin(camera)) {
    return;
  }
  looked_[camera] = now;
  LiveCamera seenWith = modelState->second;
  seenWith.intrinsics = eye.lens;
  worker_.enqueue([sight = sight_, tell = tell_, robot = robot_, key, camera, timestamp, eye, bytes = std::string{file},
                   angles, seenWith, unknown = findUncalibrated(drawing_, offsets_, cameras_),
                   offsetsKnown = !offsets_.is_null(), &drawing = drawing_] {
    std::vector<Eigen::Vector2d> corners;
    const Json boards = sight->detect(bytes, eye, corners);
    sight->end(camera);
    Json seen{{"kind", "seen"}, {"robot", robot}, {"key", key}, {"timestamp", timestamp}, {"boards", boards}};
    if (!corners.empty() && offsetsKnown) {
      seen["rests"] = predictLiveError(drawing, angles, camera, seenWith, corners, unknown).sentence(drawing, camera);
    }
    tell(jsonText(seen));
  });
}

std::string LiveDetection::cameraOf(std::string_view key) {
  return key == keys[2] ? "top" : key == keys[3] ? "bottom" : "";
}

void LiveDetection::onOffsets(const Json& offsets) {
  findUncalibrated(drawing_, offsets, {}); // throws for invalid offsets
  offsets_ = offsets;
}

void LiveDetection::onConfiguration(const Json& settings) {
  for (const Json& entry : settings.is_array() ? settings : Json::array()) {
    if (entry.at("key") != "boards") {
      continue;
    }
    std::vector<Board> boards;
    try {
      for (const JsonCursor& place : JsonCursor{entry.at("value"), "the robot's boards"}.elements()) {
        boards.push_back(readBoard(place));
      }
    } catch (const InputError&) { // the robot reports the problem itself
      return;
    }
    const std::lock_guard lock{sight_->mutex};
    sight_->boards = boards;
    sight_->places = FloorBoardTracker{std::move(boards)};
  }
}

} // namespace naocal
