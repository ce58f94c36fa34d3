#pragma once

#include "data/Capture.hpp"

#include <Eigen/Core>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

/// Positions in a picture [px] by board and corner.
inline std::map<std::pair<std::string, int>, Eigen::Vector2d> byName(const std::vector<BoardCorners>& boards) {
  std::map<std::pair<std::string, int>, Eigen::Vector2d> corners;
  for (const BoardCorners& board : boards) {
    for (std::size_t i = 0; i < board.ids.size(); ++i) {
      corners[{board.board, board.ids[i]}] = board.uv[i];
    }
  }
  return corners;
}

} // namespace naocal
