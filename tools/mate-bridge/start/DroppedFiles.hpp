#pragma once

#include "io/Files.hpp"

#include <cstdint>
#include <fstream>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// Files that a page uploads, because a browser tells no paths of files that are dropped on it: a capture set, a
/// recording, a result with its captures, or a table with what belongs to it. They are written into a temporary folder,
/// which goes with this object.
class DroppedFiles {
public:
  static constexpr std::size_t mostFiles = 10'000, longestName = 255, mostFolders = 8; // of a path: its folders
  static constexpr std::uintmax_t mostBytes = std::uintmax_t{1} << 30;                 // of all files together

  /// Number and size of files.
  struct Amount {
    std::size_t files = 0;
    std::uintmax_t bytes = 0;
  };

  /// `announced`: [{"name": relative path with "/", "bytes"}]; `before`: the files that these will be added to, which
  /// count as well. Throws InputError for too many files or bytes, for names that lead out of the folder, occur twice
  /// or hold control characters, and for files that are no documents, tables, robots' descriptions, lenses or pictures.
  explicit DroppedFiles(const nlohmann::json& announced, const Amount& before);
  explicit DroppedFiles(const nlohmann::json& announced) : DroppedFiles{announced, {}} {}

  /// Appends a part of the files' contents, one file after the other as announced. Throws InputError for more bytes
  /// than announced, and if they cannot be written.
  void append(std::string_view part);

  std::uintmax_t received() const { return received_; }
  bool isComplete() const { return next_ == files_.size(); }

  const std::filesystem::path& folder() const { return folder_.path(); }
  /// Relative paths of all files.
  std::vector<std::string> names() const;
  Amount amount() const;
  /// Whether there is a capture set among them.
  bool holdsSet() const;
  /// Whether they are to be imported: a table or a robot's description, and no capture set.
  bool holdsImport() const;

  /// Takes over the files of a complete upload; those of equal names are replaced. Throws InputError if one cannot be
  /// moved.
  void add(DroppedFiles& further);

  /// What to open: a result alone, which finds the captures beside it; otherwise the folder itself if it holds a
  /// captures.json, or else its folders, and its documents. Throws InputError if there is nothing.
  std::vector<std::string> paths() const;

private:
  struct File {
    std::string name;
    std::uintmax_t bytes = 0;
  };
  void startFiles();

  std::vector<File> files_;
  TemporaryDirectory folder_;
  std::ofstream output_; // of files_[next_]
  std::size_t next_ = 0;
  std::uintmax_t received_ = 0, left_ = 0; // left_: of files_[next_]
};

} // namespace naocal
