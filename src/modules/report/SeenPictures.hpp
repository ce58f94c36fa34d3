#pragma once

#include "io/JsonReader.hpp"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace naocal {

/// One board in one picture: where its corners were measured and where a result puts them. One column per corner.
struct SeenBoard {
  std::string board;
  std::vector<int> ids;
  Eigen::Matrix2Xd measured;  // [px]
  Eigen::Matrix2Xd predicted; // with the joints' readings as they are [px]
  Eigen::Matrix2Xd fitted;    // with the readings moved as far as their noise allows [px]
  std::vector<double> weight; // 0..1: how far each corner counted
};

/// One picture as a result file tells it.
struct SeenPicture {
  std::string set;
  int capture = 0;
  std::string pose;
  int repeat = 0;
  double time = 0; // [s]
  std::string camera;
  int width = 640, height = 480; // [px]
  std::string image;             // relative to the set's folder; empty: none kept
  std::vector<SeenBoard> boards;

  /// sqrt(mean |predicted - measured|^2) over all corners [px].
  double rms() const;
};

/// The pictures of a result file, worst first. Throws InputError with place, what was expected and found.
std::vector<SeenPicture> seenPictures(const JsonPlace& result);

} // namespace naocal
