#pragma once

#include "start/DroppedFiles.hpp"

#include "recordings/table/ColumnMap.hpp"
#include "recordings/table/CsvTable.hpp"
#include "robot/Robot.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A table of joint angles or a robot's URDF that was dropped on a page, and what was dropped with it: from the guess
/// of the columns to the capture set, as `naocal import csv` makes it.
class DroppedTable {
public:
  /// Takes the first files or further ones over; reads a table and a URDF if they are new. Throws InputError.
  void add(std::shared_ptr<DroppedFiles> files);

  /// Chooses by key: "table", "robot", "columns" (a column map), "cameraModel", "boards", "pictures" (a folder), each
  /// the name of a dropped file or a path on this computer; "cameraLink", "boardLink"; "output", a folder for the set.
  /// An empty choice is the first of the dropped files of that kind. Throws InputError for another key.
  void choose(const std::map<std::string, std::string>& choices);
  /// Gives a column a meaning, as `assignColumn`. Throws InputError.
  void assign(const std::string& column, const std::string& meaning, const std::string& unit);
  /// Replaces the column map by the text of another. Throws InputError.
  void setColumns(const std::string& text);

  /// What is known and chosen, for the page: `DroppedTable` in page/core/messages.d.ts.
  nlohmann::json state() const;

  /// A set that was written.
  struct Written {
    std::shared_ptr<const TemporaryDirectory> temporary; // holds the set; null: the chosen folder does
    std::filesystem::path set;
    bool isFolderNew = true;            // the chosen folder did not exist
    std::vector<std::string> files;     // in it, by relative path
    std::vector<std::string> sentences; // what became of the rows

    /// Removes the files from a chosen folder, and that if it is new.
    void remove() const;
  };
  /// Writes the set, into a temporary folder unless one is chosen. Throws InputError; then nothing is written.
  Written write() const;

  /// The temporary folder of the dropped files.
  const std::filesystem::path& folder() const { return files_->folder(); }

private:
  /// Files of one kind: the chosen one, and those that were dropped.
  struct Source {
    std::string chosen;
    std::vector<std::string> found;
  };

  void sortFiles();
  void read();
  void guess();
  void readTable(const std::string& name);
  void readRobot(const std::string& name);
  std::string choice(const std::string& key) const;
  std::filesystem::path pathOf(const std::string& choice) const;
  std::string usualPictures() const;
  std::string sentence() const;
  std::string originSentence() const;
  std::string picturesSentence() const;
  nlohmann::json columnsState() const;

  std::shared_ptr<DroppedFiles> files_;   // null until the first are added
  std::map<std::string, Source> sources_; // by key
  std::map<std::string, std::string> others_{{"cameraLink", ""}, {"boardLink", "world"}, {"output", ""}}; // no files
  std::vector<std::string> ignored_;                // dropped files that are nothing of this
  std::optional<CsvTable> table_;                   // of tableName_; absent: problem
  std::optional<Robot> robot_;                      // of robotName_
  std::string tableName_, robotName_, columnsName_; // as read last
  std::string tableProblem_, robotProblem_, columnsProblem_;
  ColumnMap map_;
  enum class Origin { none, guess, file, person } origin_ = Origin::none; // of `map_`
};

/// A sentence without a temporary folder's path: "the dropped files" stands for the folder itself.
std::string withoutFolder(std::string sentence, const std::filesystem::path& folder);

} // namespace naocal
