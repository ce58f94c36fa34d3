#pragma once

#include "diagnosis/evidence/Aliasing.hpp"
#include "diagnosis/views/BoardShape.hpp"
#include "diagnosis/views/ResidualField.hpp"
#include "diagnosis/views/SingleJointCorrection.hpp"
#include "inference/DriverBasis.hpp"
#include "measurements/Measurements.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace naocal {

/// Which captures poses and pictures of the measurements are, for people who look for them in the sets.
struct CaptureIndex {
  struct Pose {
    std::string set, name;
    std::vector<std::size_t> pictures; // by capture
  };
  struct Picture {
    int capture = 0; // its id
    std::string camera;
  };
  std::vector<Pose> poses;                           // as in the measurements
  std::vector<Picture> pictures;                     // as in the measurements
  std::vector<std::string> joints, boards;           // names, as in the measurements
  std::map<std::string, std::array<int, 2>> cameras; // width and height of their pictures [px]
};

CaptureIndex indexCaptures(const Measurements& measurements);

/// What a diagnosis's figures show beside its candidates' own.
struct Figures {
  /// What a model leaves over.
  struct Left {
    std::vector<SingleJointCorrection> whatIfs; // per joint
    ResidualField leftover;
    std::vector<BoardShape> shapes;
  };
  CaptureIndex taken;                 // poses and pictures, as the figures count them
  AliasMatrix aliases;                // of the first of the ranking, in the model as given
  std::vector<DriverSeries> recorded; // what joints' deflections may vary with
  Left given, last;                   // of the model as given, and with everything suggested (empty where nothing is)
};

/// How many points of a figure a diagnosis file holds: a plot some 500 pixels wide cannot show more of them apart.
constexpr std::size_t drawable = 500;
constexpr std::size_t allOfThem = std::numeric_limits<std::size_t>::max();

/// At most so many of them, spread evenly over all.
template <typename T> std::vector<T> thinOut(const std::vector<T>& all, std::size_t most) {
  if (all.size() <= most) {
    return all;
  }
  std::vector<T> result;
  for (std::size_t i = 0; i < most; ++i) {
    result.push_back(all[i * all.size() / most]);
  }
  return result;
}

} // namespace naocal
