#include "scenes/RobotScene.hpp"

#include "data/BoardFile.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "robot/RobotOfSet.hpp"
#include "robot/Urdf.hpp"
#include "scenes/ScenePoses.hpp"
#include "simulation/SimulationPlan.hpp"
#include "simulation/SyntheticCamera.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using nlohmann::json;

constexpr Range sigmaRange{0, 100, ""};

Placement placementOf(const std::vector<double>& xyz) {
  return {.x = xyz[0], .y = xyz[1], .z = xyz[2]};
}

/// The scene as the text of a capture set without captures.
json asCaptureSet(json scene, const CaptureSet& robotOnly) {
  json robot{{"model", robotOnly.model}};
  json stance{{"id", 0}};
  if (robotOnly.urdf.empty()) {
    stance["supportFoot"] = supportFootWords[static_cast<std::size_t>(robotOnly.stances.front().supportFoot)];
  } else {
    robot = {{"urdf", robotOnly.urdf}};
    if (scene.contains("base")) {
      robot["base"] = scene["base"];
    }
    if (scene.contains("supportLinks")) {
      stance["supportLinks"] = scene["supportLinks"];
    }
  }
  scene["format"] = "naocal-captures";
  scene["version"] = 2;
  scene["robot"] = robot;
  scene["jointNames"] = robotOnly.jointNames;
  scene["stances"] = json::array({stance});
  scene["captures"] = json::array();
  if (const auto distances = scene.find("distances"); distances != scene.end() && distances->is_array()) {
    for (json& distance : *distances) {
      if (distance.is_object()) {
        distance["metres"] = 1; // until it is measured
      }
    }
  }
  return scene;
}

void readNoise(const JsonCursor& place, SceneNoise& noise) {
  for (const auto& [key, value] : place.members()) {
    double* const level = key == "pixel"             ? &noise.pixel
                          : key == "encoder"         ? &noise.encoder
                          : key == "pose"            ? &noise.pose
                          : key == "approach"        ? &noise.approach
                          : key == "tracker"         ? &noise.tracker
                          : key == "trackerRotation" ? &noise.trackerRotation
                          : key == "contact"         ? &noise.contact
                                                     : nullptr;
    if (level == nullptr) {
      value.refuse("one of the noise levels pixel, encoder, pose, approach, tracker, trackerRotation and contact", key);
    }
    *level = value.number(sigmaRange);
  }
}

void readRanges(const JsonCursor& place, RobotScene& scene) {
  for (const auto& [joint, value] : place.members()) {
    const auto& names = scene.set.jointNames;
    if (std::find(names.begin(), names.end(), joint) == names.end()) {
      value.refuse("a range of a joint that the robot has", '"' + joint + '"');
    }
    const auto range = value.numbers(2, {-1000, 1000, "rad or m"}, "lowest, highest");
    if (range[0] > range[1]) {
      value.refuse("a lowest angle not above the highest");
    }
    scene.ranges[joint] = {range[0], range[1]};
  }
}

/// Reads `about` of the entries of a list or an object. `isPoint`: three coordinates instead of a placement.
void readAbout(const JsonCursor& top, const std::string& key, bool isPoint, RobotScene& scene) {
  const auto list = top.find(key);
  if (!list) {
    return;
  }
  const auto readEntry = [&](const std::string& id, const JsonCursor& entry) {
    if (const auto about = entry.find("about")) {
      scene.about[key + '.' + id] =
          isPoint ? placementOf(about->numbers(3, lengthRange, "x, y, z")) : readSparsePlacement(*about);
    }
  };
  if (list->value().is_object()) {
    for (const auto& [id, entry] : list->members()) {
      readEntry(id, entry);
    }
  } else {
    for (const JsonCursor& entry : list->elements()) {
      readEntry(entry.at("id").text(), entry);
    }
  }
}

/// Refuses what has no place to stand.
void requirePlaces(const JsonCursor& top, const RobotScene& scene) {
  const auto require = [&](bool isPlaced, const std::string& key, const std::string& id) {
    if (!isPlaced && !scene.about.contains(key + '.' + id)) {
      top.at(key).refuse(fmt::format("of \"{}\" a {}, which the simulated set tells, or `about`, which it does "
                                     "not",
                                     id, key == "places" ? "point" : "placement"),
                         "neither");
    }
  };
  for (const Board& board : scene.set.boards) {
    require(board.placement || board.hasGuess, "boards", board.id);
  }
  for (const auto& [name, mounting] : scene.set.mountings) {
    require(mounting.link != "world" || mounting.placement || mounting.guess, "cameras", name);
  }
  for (const Tracker& tracker : scene.set.instruments.trackers) {
    require(tracker.placement.has_value(), "trackers", tracker.id);
  }
  for (const ContactPlace& place : scene.set.instruments.places) {
    require(place.point.has_value(), "places", place.id);
  }
  if (!scene.set.instruments.places.empty() && scene.set.instruments.markers.empty()) {
    top.at("places").refuse("`markers` on the robot that touch them", "none");
  }
  if (!scene.set.instruments.places.empty() && standsOnSole(scene.set)) {
    top.at("places").refuse("a robot whose base stands in the world: touches are not simulated on soles",
                            "one that stands on a sole");
  }
}

} // namespace

bool standsOnSole(const CaptureSet& set) {
  const Stance& stance = set.stances.front();
  return !stance.supportLinks.empty() || stance.supportFoot != SupportFoot::none;
}

const Tracker& findTracker(const CaptureSet& set, const std::string& id) {
  const std::vector<Tracker>& trackers = set.instruments.trackers;
  return *std::find_if(trackers.begin(), trackers.end(), [&](const Tracker& tracker) { return tracker.id == id; });
}

CaptureSet makeRobotOnly(const std::string& robot, SupportFoot foot) {
  CaptureSet set;
  set.name = "simulated";
  Stance stance{.id = 0, .supportFoot = SupportFoot::none, .placement = {}, .supportLinks = {}};
  Robot description;
  if (const std::filesystem::path file = robot; file.extension() == ".urdf") {
    description = loadUrdf(file);
    set.version = 2;
    set.model.clear();
    set.folder = file.has_parent_path() ? file.parent_path() : ".";
    set.urdf = file.filename().string();
  } else {
    description = loadRobot(configurationDirectory(), robot);
    set.model = robot;
    stance.supportFoot = foot;
  }
  for (std::size_t joint = 0; joint < description.joints.size(); ++joint) {
    if (description.joints[joint].motor == joint) {
      set.jointNames.push_back(description.joints[joint].name);
    }
  }
  set.stances.push_back(stance);
  return set;
}

RobotScene readRobotScene(const std::filesystem::path& file, const CaptureSet& robotOnly) {
  return parseRobotScene(readFile(file), file.string(), robotOnly);
}

RobotScene parseRobotScene(const std::string& text, const std::string& name, const CaptureSet& robotOnly) {
  const json written = parseJson(text, name);
  const JsonCursor top{written, name};
  requireFormat(top, "naocal-scene");
  if (const auto found = top.find("captures")) {
    found->refuse("no `captures`: they are what a scene is simulated for", "them");
  }
  RobotScene scene;
  scene.set = parseCaptureSet(asCaptureSet(written, robotOnly).dump(), name).set;
  scene.set.source = nullptr;
  scene.set.name = robotOnly.name;
  scene.set.folder = robotOnly.folder;
  scene.set.version =
      robotOnly.urdf.empty() && scene.set.instruments.trackers.empty() && scene.set.instruments.places.empty() ? 1 : 2;
  for (const char* const key : {"boards", "cameras", "trackers", "frames"}) {
    readAbout(top, key, false, scene);
  }
  readAbout(top, "markers", true, scene);
  readAbout(top, "places", true, scene);
  requirePlaces(top, scene);
  if (const auto ranges = top.find("ranges")) {
    readRanges(*ranges, scene);
  }
  if (const auto noise = top.find("noise")) {
    readNoise(*noise, scene.noise);
  }
  return scene;
}

namespace {

/// A moving link that looks like a camera's optical frame, by its name.
std::optional<std::size_t> findOpticalFrame(const Robot& robot) {
  std::optional<std::size_t> found;
  for (const char* const word : {"depth_optical", "camera", "optical", "color_optical"}) { // the last one is the best
    for (std::size_t link = 0; link < robot.links.size(); ++link) {
      const bool isNamed = robot.links[link].name.find(word) != std::string::npos;
      found = isNamed && !ancestorJoints(robot, link).empty() ? link : found;
    }
  }
  return found;
}

/// The link with the most joints between it and the root.
std::size_t findLastLink(const Robot& robot) {
  std::size_t last = 0, most = 0;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    if (const std::size_t joints = ancestorJoints(robot, link).size(); joints > most) {
      last = link;
      most = joints;
    }
  }
  return last;
}

Board smallBoard() {
  Board board;
  board.id = "plate";
  board.link = "world";
  board.pattern = CharucoPattern{.squareLength = 0.03, .markerLength = 0.022};
  board.points = innerCorners(*board.pattern);
  return board;
}

/// Where on the floor, face up, a camera of the robot sees a board most often.
Placement placeInView(const Robot& robot, const RobotScene& scene, const CameraIntrinsics& camera, std::uint64_t seed) {
  constexpr int draws = 300, directions = 12;
  const Board board = smallBoard();
  ScenePoses poses{robot, scene, seed};
  std::vector<Eigen::Isometry3d> baseFromCamera;
  double reach = 0;
  for (int i = 0; i < draws; ++i) {
    if (const auto angles = poses.draw()) {
      const LinkPoses torsoFromLink = forwardKinematics(robot, *angles);
      const CameraMount& mount = robot.cameras.front();
      const RigidTransform seen = torsoFromLink[robot.base].inverse() * torsoFromLink[mount.link] *
                                  RigidTransform{mount.rotation, mount.translation};
      baseFromCamera.push_back(Eigen::Translation3d{seen.translation} * Eigen::Quaterniond{seen.rotation});
      reach = std::max(reach, seen.translation.norm());
    }
  }
  Placement best{.x = reach / 2};
  std::size_t most = 0;
  for (const double share : {0.3, 0.5, 0.7}) {
    for (int direction = 0; direction < directions; ++direction) {
      const double angle = 2 * std::numbers::pi * direction / directions;
      const Placement placement{.x = share * reach * std::cos(angle), .y = share * reach * std::sin(angle)};
      std::size_t seen = 0;
      for (const Eigen::Isometry3d& from : baseFromCamera) {
        const auto corners = visibleCorners(camera, board, from.inverse() * isometryFromPlacement(placement));
        seen += corners.ids.empty() ? 0 : 1;
      }
      if (seen > most) {
        most = seen;
        best = placement;
      }
    }
  }
  return best;
}

void addFloorScene(RobotScene& scene) {
  const Robot robot = loadRobot(scene.set);
  for (const CameraMount& camera : robot.cameras) {
    scene.set.cameras[camera.name] = nominalCameras(640, 480).begin()->second;
  }
  scene.set.boards = defaultBoards();
  for (Board& board : scene.set.boards) {
    scene.about["boards." + board.id] = *board.placement;
    board.placement.reset();
  }
}

void addTracker(const Robot& robot, RobotScene& scene) {
  const std::string last = robot.links[findLastLink(robot)].name;
  scene.set.instruments.trackers.push_back(
      {.id = "tracker", .sigma = scene.noise.tracker, .sigmaRotation = {}, .placement = {}});
  scene.about["trackers.tracker"] = {.x = 2.5, .y = 0.5, .z = 1.5, .yaw = std::numbers::pi};
  scene.set.instruments.markers.push_back({.id = "marker", .link = last, .point = {}});
  scene.about["markers.marker"] = {.x = 0.05, .y = 0.03, .z = 0.08};
}

} // namespace

RobotScene makeDefaultScene(const CaptureSet& robotOnly, std::uint64_t seed) {
  RobotScene scene{.set = robotOnly, .about = {}, .ranges = {}, .noise = {}};
  if (robotOnly.urdf.empty()) {
    addFloorScene(scene);
    return scene;
  }
  const Robot robot = loadRobot(robotOnly);
  const auto frame = findOpticalFrame(robot);
  if (!frame) {
    addTracker(robot, scene);
    return scene;
  }
  const CameraIntrinsics camera = nominalCameras(640, 480).begin()->second;
  scene.set.cameras["camera"] = camera;
  scene.set.mountings["camera"] = {.link = robot.links[*frame].name, .placement = {}, .guess = {}, .sigma = {}};
  scene.set.boards = {smallBoard()};
  scene.about["boards.plate"] = placeInView(loadRobot(scene.set), scene, camera, seed);
  return scene;
}

} // namespace naocal
