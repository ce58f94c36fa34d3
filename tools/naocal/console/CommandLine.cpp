#include "console/CommandLine.hpp"

#include "command-line/OptionChecks.hpp"
#include "console/print/PrintText.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/InputError.hpp"
#include "robot/RobotOfSet.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fmt/core.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace naocal {

std::string GivenOptions::commandLine(const std::vector<std::string>& added) const {
  std::vector<std::string> all = with;
  all.insert(all.end(), added.begin(), added.end());
  std::string result = fmt::format("{}", fmt::join(sets, " "));
  result += all.empty() ? "" : fmt::format(" --with {}", fmt::join(all, ","));
  result += without.empty() ? "" : fmt::format(" --without {}", fmt::join(without, ","));
  result += model.empty() ? "" : fmt::format(" --model {}", model);
  result += samePlace ? " --same-place" : "";
  return result + (skipBad ? " --skip-bad" : "");
}

Shard parseShard(const std::string& text) {
  Shard shard;
  if (std::sscanf(text.c_str(), "%zu/%zu", &shard.part, &shard.parts) != 2 || shard.part >= shard.parts) {
    throw InputError{fmt::format("--shard: expected i/n with i from 0 to n - 1, found \"{}\"", text)};
  }
  return shard;
}

void addLookIn(CLI::App& command, std::vector<std::string>& folders) {
  command
      .add_option("--look-in", folders,
                  "a folder to search for captures that were moved; they are recognised by their SHA-256")
      ->type_name("FOLDER")
      ->check(existingFolder())
      ->allow_extra_args(false)
      ->group(expertOptions);
}

void addFailOn(CLI::App& command, std::string& level) {
  command
      .add_option("--fail-on", level,
                  "exit code 3 if there is a finding of this level or a more serious one: stop (do not use) or act "
                  "(something is to be done)")
      ->type_name("LEVEL")
      ->check(oneOf(std::vector<std::string>{toString(FindingLevel::stop), toString(FindingLevel::act)}));
}

bool failsOn(const std::string& level, const std::vector<Finding>& findings) {
  const FindingLevel least = level == toString(FindingLevel::act) ? FindingLevel::act : FindingLevel::stop;
  return !level.empty() &&
         std::any_of(findings.begin(), findings.end(), [&](const Finding& one) { return one.level <= least; });
}

LoadedSets loadSets(const std::vector<std::string>& folders, bool skipBad) {
  LoadedSets given;
  for (const std::string& folder : folders) {
    LoadedCaptureSet read = readCaptureSet(folder, skipBad ? BadCapturePolicy::skip : BadCapturePolicy::refuse);
    for (const std::string& sentence : read.skipped) {
      printText(stderr, "left out: {}\n", sentence);
    }
    given.inputs.add(folder);
    given.sets.push_back(std::move(read.set));
  }
  std::size_t captures = 0;
  for (const CaptureSet& set : given.sets) {
    captures += set.captures.size();
  }
  if (captures >= manyCaptures) {
    printText(stderr, "{} captures: this takes minutes and much memory; a few hundred are enough for a calibration\n",
              captures);
  }
  given.robot = loadRobot(given.sets);
  return given;
}

} // namespace naocal
