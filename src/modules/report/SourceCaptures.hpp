#pragma once

#include "data/Capture.hpp"
#include "io/JsonReader.hpp"

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// One board in one picture: where its corners were measured and where a result puts them. One column per corner.
struct BoardInPicture {
  std::string board;
  std::vector<int> ids;
  Eigen::Matrix2Xd measured;  // [px]
  Eigen::Matrix2Xd predicted; // with the joints' readings as they are [px]
  Eigen::Matrix2Xd fitted;    // with the readings moved as far as their noise allows [px]
  std::vector<double> weight; // 0..1: how far each corner counted
};

/// One picture as a result file tells it.
struct PictureRecord {
  std::string set;
  int capture = 0;
  std::string pose;
  int repeat = 0;
  double time = 0; // [s]
  std::string camera;
  int width = 640, height = 480; // [px]
  std::string image;             // relative to the set's folder; empty: none kept
  std::vector<BoardInPicture> boards;

  /// sqrt(mean |predicted - measured|^2) over all corners [px].
  double rms() const;
};

/// The pictures of a result file, worst first. Throws InputError with place, what was expected and found.
std::vector<PictureRecord> readPictures(const JsonCursor& result);

/// The capture sets that a result was made of, as far as they are still there.
class SourceCaptures {
public:
  /// Looks for the folders that the result names, as they are written and beside the result file.
  SourceCaptures(const JsonCursor& result, const std::filesystem::path& resultFile);

  /// Joint readings of a picture by joint name [rad]; empty when its set is gone or has changed.
  std::map<std::string, double> angles(const PictureRecord& picture) const;

  /// The file of a picture that was kept; absent when its set is gone or has changed.
  std::optional<std::filesystem::path> image(const PictureRecord& picture) const;

  /// Rms distance of the corners from what the drawing alone predicts, floor boards where they fit best [px].
  /// Absent when a set is gone or has changed.
  std::optional<double> nominalRms() const;

  /// One sentence per set that could not be read again.
  const std::vector<std::string>& unavailable() const { return missing_; }

private:
  struct Source {
    std::filesystem::path folder;
    CaptureSet set;
  };
  std::map<std::string, Source> unchanged_; // by the set's name
  std::vector<std::string> missing_;
};

/// A picture as a data URI: grey, JPEG, at most 640 px wide. Absent when the file is not a picture.
std::optional<std::string> makeThumbnail(const std::filesystem::path& file);

} // namespace naocal
