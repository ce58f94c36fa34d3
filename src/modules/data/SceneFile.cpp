#include "data/SceneFile.hpp"

#include "data/BoardFile.hpp"
#include "io/JsonWriter.hpp"

#include <limits>

namespace naocal {

namespace {

using nlohmann::json;
using Written = nlohmann::ordered_json;

const std::vector<std::string_view> axesWords{"forward", "optical"};

CameraIntrinsics readCamera(const JsonCursor& place) {
  CameraIntrinsics camera;
  camera.width = place.at("width").integer(1, CameraIntrinsics::mostPixels);
  camera.height = place.at("height").integer(1, CameraIntrinsics::mostPixels);
  camera.fx = place.at("fx").number({1, 1e6, "px"});
  camera.fy = place.at("fy").number({1, 1e6, "px"});
  camera.cx = place.at("cx").number({-1e5, 1e5, "px"});
  camera.cy = place.at("cy").number({-1e5, 1e5, "px"});
  const auto terms = place.at("distortion").numbers(5, {-1000, 1000, ""}, "k1, k2, p1, p2, k3");
  std::copy(terms.begin(), terms.end(), camera.distortion.begin());
  return camera;
}

/// `link` is optional for a model's cameras, which its description mounts.
std::optional<CameraMounting> readMounting(const JsonCursor& place, bool isModel) {
  const auto link = place.find("link");
  if (!link && isModel) {
    return std::nullopt;
  }
  CameraMounting mounting{.link = place.at("link").text()};
  if (const auto axes = place.find("axes")) {
    mounting.isOptical = axes->wordIndex(axesWords) == 1;
  }
  if (const auto placement = place.find("placement")) {
    mounting.placement = readSparsePlacement(*placement);
  }
  if (const auto guess = place.find("placementGuess")) {
    mounting.guess = readSparsePlacement(*guess);
  }
  if (const auto sigma = place.find("placementSigma")) {
    mounting.sigma = readSigma(*sigma, false);
  }
  return mounting;
}

std::map<std::string, double> readSteps(const JsonCursor& place) {
  std::map<std::string, double> steps;
  for (const auto& [joint, step] : place.members()) {
    steps[joint] = step.number({1e-9, 100, "radians"});
  }
  return steps;
}

Written cameraJson(const CameraIntrinsics& camera, const json& read) {
  return mergeUnknownKeys({{"width", camera.width},
                           {"height", camera.height},
                           {"fx", camera.fx},
                           {"fy", camera.fy},
                           {"cx", camera.cx},
                           {"cy", camera.cy},
                           {"distortion", camera.distortion}},
                          read);
}

Written mountingJson(const CameraMounting& mounting, const json& read) {
  const auto placement = [&](const char* key, const std::optional<Placement>& given) {
    return given ? toJson(*given, false, childOrNull(read, key)) : Written();
  };
  return {{"link", mounting.link},
          {"axes", axesWords[mounting.isOptical ? 1 : 0]},
          {"placement", placement("placement", mounting.placement)},
          {"placementGuess", placement("placementGuess", mounting.guess)},
          {"placementSigma",
           mounting.sigma ? sigmaJson(*mounting.sigma, false, childOrNull(read, "placementSigma")) : Written()}};
}

Written stepsJson(const std::map<std::string, double>& steps) {
  return steps.empty() ? Written() : Written(steps);
}

} // namespace

void readCameras(const JsonCursor& place, SetReading& reading) {
  CaptureSet& set = reading.set;
  for (const auto& member : place.members()) {
    const bool isRead = reading.refusals.attempt([&] {
      const CameraIntrinsics camera = readCamera(member.second);
      const auto mounting = set.version > 1 ? readMounting(member.second, set.urdf.empty()) : std::nullopt;
      set.cameras.emplace(member.first, camera);
      if (mounting) {
        set.mountings.emplace(member.first, *mounting);
      }
    });
    if (!isRead) {
      reading.refusedCameras.insert(member.first);
    }
  }
}

void readScene(const JsonCursor& top, SetReading& reading) {
  CaptureSet& set = reading.set;
  if (const auto soles = top.find("soles")) {
    reading.refusals.attempt([&] {
      for (const auto& [link, sole] : soles->members()) {
        set.soles[link] = readSparsePlacement(sole);
      }
    });
  }
  if (const auto gravity = top.find("gravity")) {
    reading.refusals.attempt([&] {
      const auto xyz = gravity->numbers(3, {-100, 100, "m/s^2"}, "x, y, z");
      set.gravity = {xyz[0], xyz[1], xyz[2]};
      if (set.gravity.norm() < 0.1) {
        gravity->refuse("the acceleration of gravity in the world [m/s^2], such as [0, 0, -9.81]");
      }
    });
  }
  for (const auto& [key, steps] :
       {std::pair{"encoderSteps", &set.encoderSteps}, std::pair{"slipSteps", &set.slipSteps}}) {
    if (const auto given = top.find(key)) {
      reading.refusals.attempt([&, to = steps] { *to = readSteps(*given); });
    }
  }
}

Stance readStance(const JsonCursor& place, bool isModel) {
  Stance stance;
  stance.id = place.at("id").integer(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  if (isModel) {
    stance.supportFoot = static_cast<SupportFoot>(place.at("supportFoot").wordIndex(supportFootWords));
  } else {
    stance.supportFoot = SupportFoot::none;
    if (const auto links = place.find("supportLinks")) {
      stance.supportLinks = links->texts();
      if (stance.supportLinks.empty()) {
        links->refuse("the links whose soles rest on the floor");
      }
    }
  }
  if (const auto placement = place.find("placement")) {
    const bool onFloor = isModel || !stance.supportLinks.empty();
    stance.placement = onFloor ? readFloorPlacement(*placement) : readSparsePlacement(*placement);
  }
  return stance;
}

nlohmann::ordered_json camerasJson(const CaptureSet& set, const nlohmann::json& read) {
  Written cameras = Written::object();
  for (const auto& [name, camera] : set.cameras) {
    const json& before = childOrNull(read, name);
    const auto mounting = set.mountings.find(name);
    Written known = mounting == set.mountings.end() ? Written::object() : mountingJson(mounting->second, before);
    known.update(cameraJson(camera, before));
    cameras[name] = mergeUnknownKeys(known, before);
  }
  return cameras;
}

nlohmann::ordered_json sceneJson(const CaptureSet& set, const nlohmann::json& read) {
  Written soles;
  for (const auto& [link, sole] : set.soles) {
    soles[link] = toJson(sole, false, childOrNull(childOrNull(read, "soles"), link));
  }
  const bool isUsual = set.gravity == CaptureSet{}.gravity;
  return {{"soles", soles},
          {"gravity", isUsual ? Written() : Written{set.gravity.x(), set.gravity.y(), set.gravity.z()}},
          {"encoderSteps", stepsJson(set.encoderSteps)},
          {"slipSteps", stepsJson(set.slipSteps)}};
}

nlohmann::ordered_json stanceJson(const Stance& stance, bool isModel, const nlohmann::json& read) {
  const json& placement = childOrNull(read, "placement");
  const bool onFloor = isModel || !stance.supportLinks.empty();
  const auto foot = supportFootWords[static_cast<std::size_t>(stance.supportFoot)];
  return mergeUnknownKeys({{"id", stance.id},
                           {"supportFoot", isModel ? Written(foot) : Written()},
                           {"supportLinks", stance.supportLinks.empty() ? Written() : Written(stance.supportLinks)},
                           {"placement", stance.placement ? toJson(*stance.placement, onFloor, placement) : Written()}},
                          read);
}

} // namespace naocal
