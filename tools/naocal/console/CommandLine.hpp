#pragma once

#include "calibration/result/ResultFile.hpp"
#include "data/Capture.hpp"
#include "robot/Robot.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace naocal {

/// Options given on the command line, for suggesting the next command.
struct GivenOptions {
  std::vector<std::string> sets, with, without;
  std::string model;
  bool samePlace = false, skipBad = false;

  /// "captures/ --with elasticity@LKneePitch,backlash@HeadYaw --model own.json --same-place", with the effects `added`.
  std::string commandLine(const std::vector<std::string>& added = {}) const;
};

/// A part of a long evaluation: items numbered part, part + parts, part + 2 parts, ...
struct Shard {
  std::size_t part = 0, parts = 1;
};

/// Parses "2/8", the third of eight parts. Throws InputError for anything else.
Shard parseShard(const std::string& text);

/// Adds --look-in: folders in which moved captures are searched for.
void addLookIn(CLI::App& command, std::vector<std::string>& folders);

/// Adds --fail-on: the level of findings, "stop" or "act", from which on a command ends with exit code 3.
void addFailOn(CLI::App& command, std::string& level);

/// Whether there is a finding of this level or a more serious one; never of an empty level.
bool failsOn(const std::string& level, const std::vector<Finding>& findings);

inline constexpr std::size_t manyCaptures = 2000; // from this number on, a sentence says that it takes long

/// Capture sets named on the command line.
struct LoadedSets {
  std::vector<CaptureSet> sets;
  ResultSources inputs;
  Robot robot; // the drawing of the sets' model
};

/// Reads the sets; lists captures left out (`skipBad`) on standard error, and says if there are many captures.
LoadedSets loadSets(const std::vector<std::string>& folders, bool skipBad);

} // namespace naocal
