#include "SolveProblems.hpp"

#include "math/Angles.hpp"
#include "math/RigidTransform.hpp"
#include "simulation/HandMadePoses.hpp"

#include <algorithm>
#include <stdexcept>

namespace naocal {

namespace {

const std::vector<std::string> offsetJoints{"HeadYaw",   "HeadPitch",  "LHipYawPitch", "LHipRoll",
                                            "LHipPitch", "LKneePitch", "LAnklePitch",  "LAnkleRoll"};

std::vector<PlainProblem::Step> stepsTo(const Robot& robot, std::size_t link) {
  std::vector<PlainProblem::Step> steps;
  for (std::optional<std::size_t> at = link; at; at = robot.links[*at].parent) {
    PlainProblem::Step step{robot.links[*at].constant, Eigen::Vector3d::UnitZ(), -1};
    for (const Link::Stretch& stretch : robot.links[*at].stretches) {
      step.origin += robot.lengths[stretch.length].value * stretch.direction;
    }
    if (const auto joint = robot.links[*at].joint) {
      const auto name = std::find(offsetJoints.begin(), offsetJoints.end(), robot.joints[*joint].name);
      step.axis = robot.joints[*joint].axis;
      step.joint = static_cast<int>(name - offsetJoints.begin());
    }
    steps.push_back(step);
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

std::vector<Board> surveyedBoards() {
  std::vector<Board> boards;
  for (const Eigen::Vector2d& corner : {Eigen::Vector2d{0.6, 0.45}, {0.65, -0.05}, {1.1, 0.4}, {1.15, -0.1}}) {
    Board board;
    board.id = fmt::format("{}", boards.size());
    board.pattern = CharucoPattern{.squaresX = 6, .squaresY = 5};
    board.points = innerCorners(*board.pattern);
    board.placement = Placement{.x = corner.x(), .y = corner.y(), .yaw = 0.2 * static_cast<double>(boards.size())};
    boards.push_back(board);
  }
  return boards;
}

Eigen::Matrix3Xd pointsInWorld(const std::vector<Board>& boards) {
  Eigen::Matrix3Xd points(3, 0);
  for (const Board& board : boards) {
    const Placement& at = *board.placement;
    for (const Eigen::Vector3d& point : board.points) {
      points.conservativeResize(3, points.cols() + 1);
      points.rightCols<1>() = rotationZ(at.yaw) * point + Eigen::Vector3d{at.x, at.y, at.z};
    }
  }
  return points;
}

/// Projects all points at the true angles. False: a point lies behind the camera or far outside the image.
bool look(const PlainProblem& problem, PlainProblem::Pose& pose, const CameraIntrinsics& camera) {
  const auto opticalFromWorld = plainOpticalFromWorld(problem, pose, problem.trueOffsets.data());
  pose.seen.resize(2, pose.pointsInWorld.cols());
  for (Eigen::Index i = 0; i < pose.seen.cols(); ++i) {
    const Eigen::Vector3d point = opticalFromWorld.rotation * pose.pointsInWorld.col(i) + opticalFromWorld.translation;
    pose.seen.col(i) = plainPixel(problem, point);
    const Eigen::Vector2d fromCentre = (pose.seen.col(i) - problem.centre).cwiseAbs();
    if (point.z() < 0.1 || fromCentre.x() > camera.width || fromCentre.y() > camera.height) {
      return false;
    }
  }
  return true;
}

Capture captured(const Robot& robot, const std::vector<Board>& boards, const CommandedPose& commanded,
                 const PlainProblem::Pose& pose) {
  Capture capture;
  capture.pose = commanded.name;
  capture.camera = "top";
  capture.joints.measured.assign(commanded.angles.begin(), commanded.angles.end());
  for (std::size_t i = 0; i < offsetJoints.size(); ++i) {
    capture.joints.measured[*robot.jointIndex(offsetJoints[i])] = pose.measured[static_cast<Eigen::Index>(i)];
  }
  capture.corners.emplace();
  Eigen::Index next = 0;
  for (const Board& board : boards) {
    BoardCorners corners{board.id, {}, {}};
    for (std::size_t i = 0; i < board.points.size(); ++i) {
      corners.ids.push_back(static_cast<int>(i));
      corners.uv.emplace_back(pose.seen.col(next++));
    }
    capture.corners->push_back(corners);
  }
  return capture;
}

PlainProblem plainProblem(const Robot& robot, const CameraIntrinsics& camera, RandomStream& chance) {
  const CameraMount& mount = robot.cameras[*robot.cameraIndex("top")];
  PlainProblem problem;
  problem.torsoToHead = stepsTo(robot, mount.link);
  problem.torsoToSole = stepsTo(robot, robot.findSole("left")->link);
  const Eigen::Matrix3d cameraFromOptical = (Eigen::Matrix3d{} << 0, 0, 1, -1, 0, 0, 0, -1, 0).finished();
  problem.headFromOpticalRotation = mount.rotation * cameraFromOptical;
  problem.opticalInHead = mount.translation;
  problem.focalLength = camera.fx;
  problem.centre = {camera.cx, camera.cy};
  problem.trueOffsets.resize(static_cast<Eigen::Index>(offsetJoints.size()));
  for (double& offset : problem.trueOffsets) {
    offset = chance.uniformWithin(radians(6.5));
  }
  return problem;
}

} // namespace

OffsetProblem offsetProblem(const Robot& robot, std::uint64_t seed) {
  RandomStream chance{seed, "offset problem"};
  const CameraIntrinsics camera = nominalCameras(640, 480).at("top");
  OffsetProblem result{{}, plainProblem(robot, camera, chance)};
  CaptureSet& set = result.set;
  set.name = "offset problem";
  set.cameras = {{"top", camera}};
  set.boards = surveyedBoards();
  set.stances = {{0, SupportFoot::left, Placement{}}};
  for (const Joint& joint : robot.joints) {
    set.jointNames.push_back(joint.name);
  }
  const Eigen::Matrix3Xd points = pointsInWorld(set.boards);
  for (const CommandedPose& commanded : handMadePoses(robot, SupportFoot::left, 2000, seed)) {
    PlainProblem::Pose pose{result.plain.trueOffsets, points, {}};
    for (std::size_t i = 0; i < offsetJoints.size(); ++i) {
      pose.measured[static_cast<Eigen::Index>(i)] +=
          commanded.angles[static_cast<Eigen::Index>(*robot.jointIndex(offsetJoints[i]))];
    }
    if (!look(result.plain, pose, camera)) {
      continue;
    }
    for (double& number : pose.seen.reshaped()) {
      number += chance.normal(result.plain.pixelNoise);
    }
    set.captures.push_back(captured(robot, set.boards, commanded, pose));
    set.captures.back().id = static_cast<int>(set.captures.size());
    result.plain.poses.push_back(pose);
    if (set.captures.size() == 8) {
      return result;
    }
  }
  throw std::logic_error{"too few of the hand-made poses see all boards"};
}

CaptureSet fullSet(const Robot& robot, std::uint64_t seed) {
  SimulationPlan plan = handMadePlan(robot, 24);
  Board further = plan.boards.back();
  further.id = std::string{"E"};
  further.placement->y += 0.8;
  plan.boards.push_back(further);
  return simulate(robot, plan, seed).set;
}

} // namespace naocal
