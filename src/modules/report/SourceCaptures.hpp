#pragma once

#include "data/Capture.hpp"
#include "data/SetSearch.hpp"
#include "io/GreyImage.hpp"
#include "io/JsonReader.hpp"
#include "report/ResultFacts.hpp"

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// One board in one image: measured and predicted corners. One column per corner.
struct BoardInPicture {
  std::string board;
  std::vector<int> ids;
  Eigen::Matrix2Xd measured;  // [px]
  Eigen::Matrix2Xd predicted; // with joint readings as they are [px]
  Eigen::Matrix2Xd fitted;    // with readings adjusted within their noise [px]
  std::vector<double> weight; // 0..1, weight of each corner
};

/// One image in a result file.
struct PictureRecord {
  std::string set;
  int capture = 0;
  std::string pose;
  int repeat = 0;
  double time = 0; // [s]
  std::string camera;
  int width = 640, height = 480; // [px]
  std::string image;             // relative to the set's folder; empty: not stored
  std::vector<BoardInPicture> boards;

  /// sqrt(mean |predicted - measured|^2) over all corners [px].
  double rms() const;
};

/// The images of a result file, worst first; none if it has only other readings. Throws InputError with place,
/// expectation and finding.
std::vector<PictureRecord> readPictures(const JsonCursor& result);

/// What a joint read [rad], or [m] if it slides.
struct JointReading {
  double value = 0;
  std::string unit = "rad";
};

/// The capture sets of a result, as far as they are still available and unchanged (SHA-256).
class SourceCaptures {
public:
  /// Looks for the sets at their places, near the result file and in folders that the user names (`findSet`).
  SourceCaptures(const JsonCursor& result, const SetSearch& search);

  /// Joint readings of a capture by joint name; empty if its set is unavailable or has changed.
  std::map<std::string, JointReading> jointReadings(const std::string& set, int capture) const;
  /// Units of all joints of the sets that are available: "rad", or "m" of one that slides.
  const std::map<std::string, std::string>& jointUnits() const { return jointUnits_; }

  /// The stored file of an image; absent if its set is unavailable or has changed, or if the path leads out of the
  /// set's folder.
  std::optional<std::filesystem::path> image(const PictureRecord& picture) const;

  /// Errors with the drawing alone, floor boards and other unknown placements fitted. Absent if a set is unavailable or
  /// has changed.
  std::optional<DrawingErrors> drawingErrors() const;

  /// One sentence per unavailable set.
  const std::vector<std::string>& unavailable() const { return missing_; }
  /// One sentence per set that was found elsewhere than at its place.
  const std::vector<std::string>& moved() const { return moved_; }
  /// The names of all sets.
  const std::vector<std::string>& names() const { return names_; }

private:
  struct Source {
    std::filesystem::path folder;
    CaptureSet set;
  };
  void addJointUnits();

  std::map<std::string, Source> unchanged_; // by set name
  std::map<std::string, std::string> jointUnits_;
  std::vector<std::string> missing_, moved_, names_;
};

/// An image as a data URI: grey, JPEG, at most 640 px wide. Absent if the file is not an image of the described size.
std::optional<std::string> makeThumbnail(const std::filesystem::path& file, const PictureSize& described);

} // namespace naocal
