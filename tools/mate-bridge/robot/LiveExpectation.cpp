#include "robot/LiveExpectation.hpp"

#include "calibration/result/Wording.hpp"
#include "detect/LensDistortion.hpp"
#include "effects/Catalogue.hpp"
#include "robot/Kinematics.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

double sigmaOf(const std::string& effect) {
  const std::vector<Effect>& all = allEffects();
  return std::find_if(all.begin(), all.end(), [&](const Effect& one) { return one.name == effect; })
      ->unknowns.front()
      .sigma;
}

/// soleFromOptical of the drawing at `angles`; `turned`: mount rotation.
RigidTransform seenFrom(const Sole& sole, const Robot& drawing, const Eigen::VectorXd& angles, std::size_t camera,
                        const Eigen::Vector3d& turned) {
  const LinkPoses torsoFromLink = forwardKinematics(drawing, angles);
  ModelState believed = nominalState(drawing, {drawing.joints.size(), drawing.lengths.size(), 0});
  believed.mountRotation() = turned;
  const CameraMount& mount = drawing.cameras[camera];
  return torsoFromLink[sole.link].inverse() * torsoFromLink[mount.link] * linkFromOptical(mount, believed);
}

/// Removes a camera motion's yaw and translation in the floor plane, which the tracked boards absorb.
RigidTransform withoutPlane(const RigidTransform& motion) {
  const double yaw =
      std::atan2(motion.rotation(1, 0) - motion.rotation(0, 1), motion.rotation(0, 0) + motion.rotation(1, 1));
  const RigidTransform plane{rotationZ(yaw), {motion.translation.x(), motion.translation.y(), 0}};
  return plane.inverse() * motion;
}

/// Mean square shift of corners when the camera moves [px^2]; skips corners above the horizon.
double meanSquare(const RigidTransform& floorFromOptical, const RigidTransform& moved, const CameraIntrinsics& lens,
                  const std::vector<Eigen::Vector2d>& pixels) {
  const RigidTransform left = withoutPlane(moved * floorFromOptical.inverse()) * floorFromOptical;
  double sum = 0;
  std::size_t count = 0;
  for (const Eigen::Vector2d& pixel : pixels) {
    const auto place = intersectFloor(floorFromOptical, lens, pixel);
    if (!place) {
      continue;
    }
    const Eigen::Vector3d seen = left.inverse() * Eigen::Vector3d{place->x(), place->y(), 0};
    if (seen.z() <= 0) {
      continue;
    }
    const Eigen::Vector2d there = LensDistortion{lens}.distort(
        {lens.fx * seen.x() / seen.z() + lens.cx, lens.fy * seen.y() / seen.z() + lens.cy});
    sum += (there - pixel).squaredNorm();
    ++count;
  }
  return count > 0 ? sum / double(count) : 0;
}

/// The supporting soles: the lower one, or both.
std::vector<const Sole*> carrying(const Robot& drawing, const Eigen::VectorXd& angles) {
  const std::string carries = RobotOutline{drawing, angles}.carries();
  std::vector<const Sole*> soles;
  for (const char* const name : {"left", "right"}) {
    if (const Sole* const sole = drawing.findSole(name); sole && (carries == "both" || carries == name)) {
      soles.push_back(sole);
    }
  }
  return soles;
}

/// Corners that a camera sees while one sole supports the robot.
struct LiveView {
  const Robot& drawing;
  const Sole& sole;
  std::size_t camera;
  const LiveCamera& modelState;
  const Eigen::VectorXd& angles;
  const std::vector<Eigen::Vector2d>& pixels;
  RigidTransform soleFromOptical;
};

// Errors are small steps, scaled linearly: full steps could move boards beyond the horizon.
constexpr double smallStep = 1e-3; // [rad]

/// Mean square shift of the corners by the offset of an uncalibrated joint [px^2].
double squareByJoint(const LiveView& view, std::size_t joint) {
  const double perStep = sigmaOf(effectName::jointOffset) / smallStep;
  Eigen::VectorXd moved = view.angles;
  moved[static_cast<Eigen::Index>(joint)] -= smallStep;
  return meanSquare(view.soleFromOptical,
                    seenFrom(view.sole, view.drawing, moved, view.camera, view.modelState.rotation),
                    view.modelState.intrinsics, view.pixels) *
         perStep * perStep;
}

/// Mean square shift of the corners by an uncalibrated rotation of the mount about an axis [px^2].
double squareByMount(const LiveView& view, int axis) {
  const double perStep = sigmaOf(effectName::cameraRotation) / smallStep;
  Eigen::Vector3d turned = view.modelState.rotation;
  turned[axis] += smallStep;
  return meanSquare(view.soleFromOptical, seenFrom(view.sole, view.drawing, view.angles, view.camera, turned),
                    view.modelState.intrinsics, view.pixels) *
         perStep * perStep;
}

/// If `joints` has all joints of a leg, removes them and adds "the left leg" to `limbs`.
void takeLimb(const Robot& drawing, const std::string& side, std::vector<std::string>& joints,
              std::vector<std::string>& limbs) {
  std::vector<std::string> all;
  for (const std::size_t joint : ancestorJoints(drawing, drawing.findSole(side)->link)) {
    all.push_back(drawing.joints[joint].name);
  }
  const auto has = [&](const std::string& name) {
    return std::find(joints.begin(), joints.end(), name) != joints.end();
  };
  if (std::all_of(all.begin(), all.end(), has)) {
    std::erase_if(joints,
                  [&](const std::string& name) { return std::find(all.begin(), all.end(), name) != all.end(); });
    limbs.push_back("the " + side + " leg");
  }
}

} // namespace

Uncalibrated findUncalibrated(const Robot& drawing, const Json& offsets, const LiveCameras& cameras) {
  Uncalibrated result;
  for (const Json& entry : offsets) {
    std::string name = entry.at("key");
    name[0] = static_cast<char>(std::toupper(name[0]));
    if (drawing.jointIndex(name) && entry.at("value").is_number() && entry.at("value").get<double>() == 0) {
      result.joints.insert(name);
    }
  }
  for (const auto& [name, camera] : cameras) {
    if (camera.rotation.isZero(0)) {
      result.cameras.insert(name);
    }
  }
  return result;
}

LiveExpectation predictLiveError(const Robot& drawing, const Eigen::VectorXd& angles, const std::string& camera,
                                 const LiveCamera& modelState, const std::vector<Eigen::Vector2d>& pixels,
                                 const Uncalibrated& uncalibrated) {
  const auto index = drawing.cameraIndex(camera);
  const std::vector<const Sole*> soles = carrying(drawing, angles);
  LiveExpectation result;
  if (!index || soles.empty()) {
    return result;
  }
  const std::vector<std::size_t> neck = ancestorJoints(drawing, drawing.cameras[*index].link);
  const auto legs = double(soles.size());
  std::set<std::size_t> counted;
  double squares = 0;
  for (const Sole* const sole : soles) {
    const LiveView view{drawing,
                        *sole,
                        *index,
                        modelState,
                        angles,
                        pixels,
                        seenFrom(*sole, drawing, angles, *index, modelState.rotation)};
    std::vector<std::size_t> chain = ancestorJoints(drawing, sole->link);
    chain.insert(chain.end(), neck.begin(), neck.end());
    for (const std::size_t joint : chain) {
      if (!uncalibrated.joints.contains(drawing.joints[joint].name)) {
        continue;
      }
      const double square = squareByJoint(view, joint);
      const bool isOfNeck = std::find(neck.begin(), neck.end(), joint) != neck.end(); // common to both soles
      squares += square * (isOfNeck ? 1.0 / legs : 1.0 / (legs * legs)); // variance of a mean of independent legs
      constexpr double unseen = 1;                                       // [px^2]; smaller contributions are not listed
      if (square > unseen) {
        counted.insert(joint);
      }
    }
    for (int axis = 0; axis < 3 && uncalibrated.cameras.contains(camera); ++axis) {
      squares += squareByMount(view, axis) / legs;
      result.camera = true;
    }
  }
  for (const std::size_t joint : counted) {
    result.joints.push_back(drawing.joints[joint].name);
  }
  result.px = std::sqrt(squares);
  return result;
}

std::string LiveExpectation::sentence(const Robot& drawing, const std::string& name) const {
  std::vector<std::string> rest = joints, what;
  for (const char* const side : {"left", "right"}) {
    takeLimb(drawing, side, rest, what);
  }
  what.insert(what.end(), rest.begin(), rest.end());
  if (camera) {
    what.push_back(fmt::format("the {} camera's mount", name));
  }
  if (what.empty()) {
    return "All joints between the floor and this camera are calibrated.";
  }
  std::string list = joinWords(what);
  list[0] = static_cast<char>(std::toupper(list[0]));
  return fmt::format("{} {} never calibrated: errors up to {:.0f} px are plausible.", list,
                     what.size() > 1 ? "were" : "was", px);
}

} // namespace naocal
