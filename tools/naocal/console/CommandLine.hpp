#pragma once

#include "calibration/ResultFile.hpp"
#include "data/Capture.hpp"
#include "robot/Robot.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// What a person gave on the command line, for commands that go on from there.
struct GivenOptions {
  std::vector<std::string> sets, with, without;
  std::string model;
  bool samePlace = false, skipBad = false;

  /// "captures/ --with elasticity@LKneePitch,backlash@HeadYaw --model own.json --same-place", with these effects added.
  std::string commandLine(const std::vector<std::string>& added = {}) const;
};

/// A part of a long evaluation: of its pieces those numbered part, part + parts, part + 2 parts, ...
struct Shard {
  std::size_t part = 0, parts = 1;
};

/// Reads "2/8", the third of eight parts. Throws InputError for anything else.
Shard parseShard(const std::string& text);

/// Capture sets as a command was given them.
struct LoadedSets {
  std::vector<CaptureSet> sets;
  ResultInputs inputs;
  Robot robot; // the drawing of the sets' model
};

/// Reads the sets; captures that were left out (`skipBad`) are told on standard error.
LoadedSets loadSets(const std::vector<std::string>& folders, bool skipBad);

} // namespace naocal
