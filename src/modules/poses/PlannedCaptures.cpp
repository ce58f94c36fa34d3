#include "poses/PlannedCaptures.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace naocal {

namespace {

/// Of the fitted robot: half of what is asked of the drawn one, for what the fit does not know.
constexpr Footing fittedFooting{0.01, 0.01};

/// In the order of the set's joints; 0 for those that the drawing does not hold (fingers).
std::vector<double> listed(const CaptureSet& set, const Robot& robot, const Eigen::VectorXd& perJoint) {
  std::vector<double> result;
  for (const std::string& name : set.jointNames) {
    const auto joint = robot.jointIndex(name);
    result.push_back(joint ? perJoint[static_cast<Eigen::Index>(*joint)] : 0);
  }
  return result;
}

/// As the set's last capture, but for what the pose changes.
Capture plannedCapture(const CaptureSet& set, const Robot& robot, const ProposedPose& planned) {
  const Capture& last = set.captures.back();
  Capture capture;
  capture.time = last.time + Seconds{30};
  capture.supportFoot = planned.pose.supportFoot;
  capture.joints.measured = listed(set, robot, planned.pose.angles);
  if (!last.joints.velocity.empty()) {
    capture.joints.velocity.assign(set.jointNames.size(), 0);
  }
  if (!last.joints.approach.empty()) {
    capture.joints.approach = listed(set, robot, planned.approach);
  }
  capture.joints.temperature = last.joints.temperature;
  capture.joints.current = last.joints.current;
  capture.imu = last.imu;
  capture.fsr = last.fsr;
  return capture;
}

} // namespace

std::vector<BoardCorners> seenBy(const std::string& camera, const std::vector<Sight>& sights) {
  std::vector<BoardCorners> result;
  for (const Sight& sight : sights) {
    if (sight.camera == camera) {
      const std::vector<Eigen::Vector2d> nothing(sight.corners.size(), Eigen::Vector2d::Zero());
      result.push_back({sight.board, sight.corners, nothing});
    }
  }
  return result;
}

std::string plannedName(std::size_t pose) {
  return fmt::format("planned {:06}", pose);
}

int plannedStance(const std::vector<CaptureSet>& sets, SupportFoot foot) {
  int highest = -1;
  for (const CaptureSet& set : sets) {
    for (const Stance& stance : set.stances) {
      highest = std::max(highest, stance.id);
    }
  }
  return highest + (foot == SupportFoot::left ? 1 : 2);
}

std::vector<CaptureSet> withPlanned(const std::vector<CaptureSet>& sets, const Robot& robot,
                                    const std::vector<ProposedPose>& poses) {
  std::vector<CaptureSet> result = sets;
  CaptureSet& set = result.back();
  for (const SupportFoot foot : {SupportFoot::left, SupportFoot::right}) {
    set.stances.push_back({plannedStance(sets, foot), foot, std::nullopt});
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    Capture capture = plannedCapture(sets.back(), robot, poses[i]);
    capture.pose = plannedName(i);
    capture.stance = plannedStance(sets, capture.supportFoot);
    for (const auto& [camera, lens] : set.cameras) {
      capture.camera = camera;
      capture.corners = seenBy(camera, poses[i].pose.sights);
      set.captures.push_back(capture);
    }
  }
  return result;
}

std::vector<ProposedPose> feasibleByFit(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                                        const Model& model, const Eigen::VectorXd& unknowns,
                                        const std::vector<Surroundings>& around, std::vector<ProposedPose> poses) {
  const Robot& robot = measurements.robot;
  std::map<SupportFoot, Scene> scenes;
  for (const Surroundings& here : around) {
    scenes.try_emplace(here.supportFoot, robot, here.supportFoot, here.boards, sets.back().cameras, SightLimits{});
  }
  std::map<std::size_t, Picture> pictures; // per camera in use, the last one: only its angles will change
  for (const Picture& picture : measurements.pictures) {
    pictures.insert_or_assign(picture.camera, picture);
  }
  const auto ofRobot = static_cast<Eigen::Index>(measurements.quantities.lens()); // angles, lengths, mount
  for (ProposedPose& planned : poses) {
    PlannedPose& pose = planned.pose;
    const Scene& scene = scenes.at(pose.supportFoot);
    pose.sights.clear();
    for (auto& [camera, picture] : pictures) {
      picture.instant.supportFoot = pose.supportFoot;
      picture.instant.q = pose.angles;
      picture.drawn.values.head(pose.angles.size()) = pose.angles;
      Belief belief = scene.drawn();
      belief.values.head(ofRobot) = believed(measurements, model, picture, unknowns).values.head(ofRobot);
      const Posture torsoFromLink = posture(robot, belief);
      if (!stands(robot, torsoFromLink, pose.supportFoot, fittedFooting)) {
        break;
      }
      for (Sight& sight : scene.sights(belief, torsoFromLink)) {
        if (sight.camera == robot.cameras[camera].name) {
          pose.sights.push_back(std::move(sight));
        }
      }
    }
  }
  std::erase_if(poses, [](const ProposedPose& planned) { return planned.pose.sights.empty(); });
  return poses;
}

} // namespace naocal
