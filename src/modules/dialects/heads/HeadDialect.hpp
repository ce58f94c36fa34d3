#pragma once

#include "dialects/heads/HeadCamera.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// The direction of a head's camera as read from a file.
struct HeadDirection {
  Eigen::Matrix3d neckFromCamera = Eigen::Matrix3d::Identity();
  std::optional<double> baseOffset; // of the joint below the neck [rad]; absent: the file has no place for it
  std::vector<std::string> unused;  // what of the file's corrections this does not hold
};

/// How another team's robot holds the direction of its head's camera. Its file holds more than that, and exists:
/// corrections that are known are replaced in it, everything else stays to the byte. Reading what was written gives the
/// same numbers, to the printed digit. The camera's position is not in these files.
struct HeadDialect {
  std::string_view name; // on the command line
  std::string_view what; // for the help
  bool hasBase = false;  // it has a place for the offset of the joint below the neck
  /// The text with the camera's direction and the base's offset written into it, as far as they are known; `file`
  /// stands for the text in messages. Throws InputError for another kind of file and for a robot that it is not made
  /// for.
  std::string (*write)(const std::string& text, const std::string& file, const Robot& robot, const HeadCamera& head);
  /// Reads the direction; throws as `write`.
  HeadDirection (*parse)(const std::string& text, const std::string& file, const Robot& robot, const HeadCamera& head);
};

} // namespace naocal
