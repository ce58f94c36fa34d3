#pragma once

#include "calibration/result/CalibrationResult.hpp"

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// One reading of a tracker, or one contact, and where the fit predicts it, in the axes of the world.
struct ReadingRecord {
  enum class Kind { point, frame, contact };
  /// Predicted - measured: of a position [m], and of a frame's attitude as a rotation vector [rad].
  struct Error {
    Eigen::Vector3d shift = Eigen::Vector3d::Zero(), turn = Eigen::Vector3d::Zero();
  };

  std::size_t picture = 0; // index into `Measurements::pictures`
  Kind kind = Kind::point;
  std::string instrument;                             // the tracker, or `contactLevel`
  std::string target;                                 // the marker or frame
  std::string place;                                  // that was touched; empty for trackers
  Eigen::Vector3d measured = Eigen::Vector3d::Zero(); // where the reading lies in the world of the fit [m]
  Error reported, fitted; // with joint readings as they are; with readings adjusted within their noise
};

/// All readings, in the order of the pictures.
///
///   measured = worldFromTracker * xyz, or the place that was touched
///
/// where the tracker and the place are as the fit has them.
std::vector<ReadingRecord> recordReadings(const FittedModel& fitted);

/// Keys `kind`, `instrument`, `target`, `place`, `measured`, `predicted` and `fitted` (positions in the world [m]) and,
/// of frames, `turn` with `predicted` and `fitted` [rad]. Rounded to a tenth of a micrometre and a microradian.
nlohmann::json toJson(const ReadingRecord& record);

/// The noise levels of the readings with `noise`.
std::vector<ReadingLevel> readingLevels(const Measurements& measurements, const Noise& noise);

/// 1 sigma per axis by instrument and unit, and whether the set gave it:
/// {"laser": {"metres": {"sigma": 0.0003, "source": "given"}}}
nlohmann::json toJson(const std::vector<ReadingLevel>& levels);

} // namespace naocal
