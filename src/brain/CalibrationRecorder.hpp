#pragma once

#include "calibration/EffectiveOffsets.hpp"
#include "calibration/result/ResultFile.hpp"
#include "data/Capture.hpp"
#include "estimation/ModelFile.hpp"
#include "hardware/CameraInterface.hpp"
#include "robot/Robot.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace naocal {

/// Records a calibration's captures: writes each image and the updated set at once, so that a recording is complete up
/// to the last capture after any failure.
class CalibrationRecorder {
public:
  /// `header`: robot, cameras, boards and stances of the set. `model`: effects estimated in addition to offsets
  /// and mounts. Throws InputError if the folder already holds a set.
  CalibrationRecorder(const Robot& drawing, CaptureSet header, std::filesystem::path folder, ModelFile model);

  /// Detects boards in an image, writes the image and its capture, and returns the corners; empty for an incomplete
  /// image. Throws InputError if it cannot write.
  std::vector<BoardCorners> record(Capture capture, const CameraFrame& frame);

  std::size_t captures() const { return set_.captures.size(); }
  std::size_t corners() const { return corners_; }

  /// Joint offsets and camera mounts; on one foot also the model's effects.
  struct Solution {
    StoredResult result; // as read back from its file
    std::vector<EffectiveOffset> offsets;
    std::vector<Finding> findings; // of the fit, beside its verdict
  };
  /// Estimates them from the captures; writes result.json and offsets.json beside them. Throws InputError if there is
  /// nothing to fit or the solver does not converge.
  Solution solve() const;

  /// The verdict of 'naocal diagnose' on the captures, in one or two sentences; writes diagnosis.json beside them.
  std::string diagnose() const;

  /// RMS distance between this session's corners and their prediction, for two calibrations [px].
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
