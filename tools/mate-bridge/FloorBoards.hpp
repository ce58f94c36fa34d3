#pragma once

#include "data/Capture.hpp"
#include "math/RigidTransform.hpp"

#include <Eigen/Core>
#include <deque>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// A picture's camera when it was taken.
struct Eye {
  RigidTransform floorFromOptical;
  CameraIntrinsics lens;
};

/// Boards on the floor as pictures show them, one after the other: where each lies in the mean of its last views, and
/// where a picture should hence show its corners. What is off from picture to picture is what the robot does not know
/// about its joints and cameras.
class FloorBoards {
public:
  explicit FloorBoards(std::vector<Board> boards) : boards_{std::move(boards)} {}

  /// Takes a view of a board in; afterwards `predicted` tells where these corners should have been [px]. Empty: the
  /// picture does not tell where it lies (a corner above the horizon), or there is no such board or corner.
  std::vector<Eigen::Vector2d> predicted(const BoardCorners& seen, const Eye& eye);

  /// For a plan: [{"id", "columns", "rows", "square", "x", "y", "yaw"}] of those seen so far [m, rad].
  nlohmann::json drawn() const;

private:
  struct Place {
    double x = 0, y = 0, yaw = 0; // floorFromBoard [m, rad]
  };
  const Board* board(const std::string& id) const;
  Place mean(const std::string& id) const;

  std::vector<Board> boards_;
  std::map<std::string, std::deque<Place>> views_; // by board, the last ones
};

} // namespace naocal
