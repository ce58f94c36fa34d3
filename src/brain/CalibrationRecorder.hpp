#pragma once

#include "calibration/EffectiveOffsets.hpp"
#include "calibration/ResultFile.hpp"
#include "data/Capture.hpp"
#include "estimation/ModelFile.hpp"
#include "hardware/CameraInterface.hpp"
#include "robot/Robot.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace naocal {

/// A calibration's captures as they come: each one's picture and the set are written at once, so that what was recorded
/// is readable up to the last capture whatever happens.
class CalibrationRecorder {
public:
  /// `header`: robot, cameras, boards and stances of the set. Its folder must not hold a set yet. `model`: what is
  /// estimated beside offsets and mounts.
  CalibrationRecorder(const Robot& drawing, CaptureSet header, std::filesystem::path folder, ModelFile model);

  /// Finds the boards in a picture, writes it with its capture, and says what was found. Throws InputError where it
  /// cannot be written.
  std::vector<BoardCorners> record(Capture capture, const CameraFrame& frame);

  std::size_t captures() const { return set_.captures.size(); }
  std::size_t corners() const { return corners_; }

  /// Joints' offsets and cameras' mounts, on one foot the model's effects too.
  struct Solution {
    StoredResult result; // as in its file
    std::vector<ShownOffset> offsets;
    std::vector<Warning> warnings;
  };
  /// Estimates them from the captures, and writes result.json and offsets.json beside them. Throws InputError when
  /// there is nothing to fit, or the search does not converge.
  Solution solve() const;

  /// What 'naocal diagnose' says of the captures, in a sentence or two; diagnosis.json is written beside them.
  std::string diagnose() const;

  /// How far this session's corners are from where each of two calibrations has them [px].
  struct ErrorComparison {
    double before = 0, after = 0;
  };
  ErrorComparison compareErrors(const StoredResult& before, const StoredResult& after) const;

private:
  const Robot& drawing_;
  CaptureSet set_;
  std::filesystem::path folder_;
  ModelFile model_;
  std::size_t corners_ = 0;
};

} // namespace naocal
