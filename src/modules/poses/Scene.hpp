#pragma once

#include "captures/Capture.hpp"
#include "geometry/Angles.hpp"
#include "model/Picture.hpp"

#include <map>
#include <string>
#include <vector>

namespace naocal {

/// When a corner counts as seen: the detector must be able to measure it.
struct SightLimits {
  double nearest = 0.4, farthest = 1.6; // from the camera [m]
  double grazing = radians(15);         // least angle between ray and board [rad]
  double border = 10;                   // least distance to the picture's edge [px]
  std::size_t corners = 8;              // a board with fewer is not seen
  bool wholeBoards = false;             // nor is one that is not wholly in the picture
};

/// A board that a camera sees.
struct Sight {
  std::string camera, board;
  std::vector<int> corners; // ids
};

/// A robot on one sole, boards around it on the floor, and what its cameras see of them.
class Scene {
public:
  /// `boards`: with their placements in the support sole's frame, else InputError. `cameras`: by the robot's names.
  Scene(const Robot& robot, const Sole& support, const std::vector<Board>& boards,
        const std::map<std::string, CameraIntrinsics>& cameras, const SightLimits& limits);

  /// The drawn robot on its sole among the boards, all angles zero.
  const Belief& drawn() const { return drawn_; }

  /// Joints between the sole and the cameras, by their motors.
  std::vector<std::size_t> joints() const;

  std::vector<Sight> sights(const Belief& belief, const Posture& torsoFromLink) const;

  /// J^T J over the corners in sight, for 1 px of noise: what the pictures of a pose tell about the unknowns: an offset
  /// per joint of the drawing (at its motor) [rad], three rotations per camera [rad], and x, y [m], yaw [rad] per
  /// board.
  Eigen::MatrixXd information(const Belief& belief, const Posture& torsoFromLink) const;

  /// What is known of them before any picture: 1 / sigma^2 on the diagonal.
  Eigen::MatrixXd priorInformation() const;

private:
  /// One camera before one board.
  struct Outlook {
    std::size_t camera;
    CameraIntrinsics lens;
    View view;
    CornerBlocks corners;
  };

  /// Where the board's corners come to lie in the picture, and which of them are seen.
  struct Projection {
    Attitude attitude;
    ProjectedBlocks corners;
    std::vector<int> seen; // ids
  };
  Projection projection(const Outlook& outlook, Belief& belief, const Posture& torsoFromLink) const;

  const Robot& robot_;
  SightLimits limits_;
  std::vector<Board> boards_;
  Quantities quantities_;
  Belief drawn_;
  std::vector<Outlook> outlooks_;
};

} // namespace naocal
