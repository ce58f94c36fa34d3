#pragma once

#include "dialects/RobotCalibration.hpp"
#include "robot/Robot.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// A file of a dialect: its name there, and its text.
struct DialectFile {
  std::string name, text;
};

/// How another program writes a calibration. Reading what was written gives the same numbers, to the printed digit.
struct Dialect {
  std::string_view name;       // on the command line
  std::string_view what;       // for the help
  bool namesAllJoints = false; // a joint that a file does not name counts as 0 there
  bool hasJoints = false;
  /// Files of a calibration; `robot` is the drawing. Throws InputError if the calibration has nothing that the dialect
  /// has a place for.
  std::vector<DialectFile> (*write)(const RobotCalibration& calibration, const Robot& robot) = nullptr;
  /// Reads one of its files; `file` is the path, for messages. Throws InputError with place, expected and found.
  ParsedCalibration (*parse)(const std::string& text, const std::string& file, const Robot& robot) = nullptr;
};

} // namespace naocal
