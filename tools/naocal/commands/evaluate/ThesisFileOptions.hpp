#pragma once

#include "evaluation/thesis/ThesisExperiment.hpp"

#include <CLI/App.hpp>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Options of `naocal evaluate thesis` that replace error sets, poses, features and held-out poses by those of files,
/// or write them to files. What is not given is that of the thesis's own program, on its floor grid.
struct ThesisFileOptions {
  std::string errors, poses, features, test;                     // files to read
  std::string writeErrors, writePoses, writeFeatures, writeTest; // files to write
  std::size_t samples = 1;                                       // per pose

  void add(CLI::App& command);
  /// Whether a file is given.
  bool isUsed() const;
};

/// What to evaluate with files.
struct ThesisFileRun {
  ThesisSetting setting; // without noise
  ThesisInputs inputs;
  std::vector<Eigen::VectorXd> poses;        // angles of all joints [rad]
  std::map<std::string, std::string> hashes; // SHA-256 of the files read, by option
};

/// Reads the files, and writes those that are asked for; `sets`, `seed`: of error sets that are drawn. Throws
/// InputError for a file that does not fit.
ThesisFileRun prepareFileRun(const ThesisFileOptions& files, const Robot& robot, std::size_t sets, std::uint64_t seed);

} // namespace naocal
