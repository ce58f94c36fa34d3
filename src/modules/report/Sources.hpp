#pragma once

#include "data/Capture.hpp"
#include "io/JsonReader.hpp"
#include "report/SeenPictures.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// The capture sets that a result was made of, as far as they are still there.
class Sources {
public:
  /// Looks for the folders that the result names, as they are written and beside the result file.
  Sources(const JsonPlace& result, const std::filesystem::path& resultFile);

  /// Joint readings of a picture by joint name [rad]; empty when its set is gone or has changed.
  std::map<std::string, double> angles(const SeenPicture& picture) const;

  /// The file of a picture that was kept; absent when its set is gone or has changed.
  std::optional<std::filesystem::path> image(const SeenPicture& picture) const;

  /// Rms distance of the corners from what the drawing alone predicts, floor boards where they fit best [px].
  /// Absent when a set is gone or has changed.
  std::optional<double> drawingRms() const;

  /// One sentence per set that could not be read again.
  const std::vector<std::string>& missing() const { return missing_; }

private:
  struct Source {
    std::filesystem::path folder;
    CaptureSet set;
  };
  std::map<std::string, Source> unchanged_; // by the set's name
  std::vector<std::string> missing_;
};

} // namespace naocal
