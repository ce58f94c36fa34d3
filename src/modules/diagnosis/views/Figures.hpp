#pragma once

#include "calibration/ReadingRecords.hpp"
#include "diagnosis/evidence/Aliasing.hpp"
#include "diagnosis/views/BoardShape.hpp"
#include "diagnosis/views/PartialResidual.hpp"
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

/// Maps poses and pictures of the measurements to captures, for display.
struct CaptureIndex {
  struct Pose {
    std::string set, name;
    std::vector<std::size_t> pictures; // in order of capture
  };
  struct Picture {
    int capture = 0; // capture id
    std::string camera;
  };
  std::vector<Pose> poses;                           // in the order of the measurements
  std::vector<Picture> pictures;                     // in the order of the measurements
  std::vector<std::string> joints, boards;           // names, in the order of the measurements
  std::map<std::string, std::array<int, 2>> cameras; // image width and height [px]
};

/// Poses and pictures in the order of the measurements.
CaptureIndex indexCaptures(const Measurements& measurements);

/// Figures of a diagnosis, besides those of its candidates.
struct Figures {
  /// Residuals of a model in several views.
  struct Left {
    std::vector<SingleJointCorrection> whatIfs; // per joint: its deflection that would explain each pose's misfit
    ResidualField leftover;                     // what no rigid motion of a picture explains
    std::vector<BoardShape> shapes;
    std::vector<ReadingRecord> readings;
    std::vector<ReadingLevel> readingLevels; // their noise
  };
  CaptureIndex taken;                  // poses and pictures as indexed by the figures
  AliasMatrix aliases;                 // first candidates of the ranking, in the model as given
  std::vector<DriverSeries> recorded;  // drivers that joint deflections may depend on
  Left given, last;                    // model as given; model with all suggestions (empty if there are none)
  std::vector<PartialResidual> causes; // of each suggestion, of the unnamed curve, or of what is negligible
};

/// Upper limit of points per figure in a diagnosis file: the resolution of a plot about 500 pixels wide.
constexpr std::size_t drawable = 500;
constexpr std::size_t allOfThem = std::numeric_limits<std::size_t>::max();

/// Evenly spaced subset of at most `most` elements.
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
