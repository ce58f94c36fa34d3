#include "commands/evaluate/ThesisFileOptions.hpp"

#include "console/OutputFiles.hpp"

#include "command-line/OptionChecks.hpp"
#include "evaluation/thesis/ThesisFiles.hpp"
#include "evaluation/thesis/ThesisPoses.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>

namespace naocal {

namespace {

constexpr double widestOffset = 0.5, widestAngle = 3.2; // [rad]

/// Reads a file and keeps its hash.
template <typename Read> auto readInput(const std::string& file, const char* option, ThesisFileRun& run, Read read) {
  run.hashes[option] = sha256(readFile(file));
  return read(file);
}

void writeOutputs(const ThesisFileOptions& files, const ThesisFileRun& run, const std::vector<Eigen::VectorXd>& poses) {
  const std::vector<std::string> names = programJoints();
  if (!files.writeErrors.empty()) {
    writeTable(files.writeErrors, formatJointTable(errorsKind, names, run.inputs.offsets));
  }
  if (!files.writePoses.empty()) {
    writeTable(files.writePoses, formatJointTable(posesKind, names, poses));
  }
  if (!files.writeFeatures.empty()) {
    writeTable(files.writeFeatures, formatFeatures(run.inputs.features));
  }
  if (!files.writeTest.empty()) {
    writeTable(files.writeTest, formatJointTable(posesKind, names, run.inputs.heldOut));
  }
}

} // namespace

void ThesisFileOptions::add(CLI::App& command) {
  const std::string group = "Files (CSV; instead of the tables, one setting per kind of noise)";
  const auto read = [&](const char* option, std::string& file, const char* help) {
    command.add_option(option, file, help)->type_name("FILE")->group(group);
  };
  const auto write = [&](const char* option, std::string& file, const char* help, std::string_view kind) {
    command.add_option(option, file, help)->type_name("FILE")->check(replaceableTable(kind))->group(group);
  };
  read("--errors", errors, "error sets: joint offsets [rad], a column per joint");
  read("--poses", poses, "poses on the left foot: joint angles [rad], a column per joint");
  read("--features", features, "floor points: columns,rows,spacing,x,y,yaw [m, rad] in the left sole's frame");
  read("--test", test, "held-out poses, like --poses");
  command.add_option("--samples", samples, "samples of the joints' noise per pose, with files")
      ->check(wholeNumber(1, 100))
      ->capture_default_str()
      ->group(group);
  write("--write-errors", writeErrors, "the error sets that are used", errorsKind);
  write("--write-poses", writePoses, "the poses that are used", posesKind);
  write("--write-features", writeFeatures, "the floor points that are used", featuresKind);
  write("--write-test", writeTest, "the held-out poses that are used", posesKind);
}

bool ThesisFileOptions::isUsed() const {
  const auto all = {errors, poses, features, test, writeErrors, writePoses, writeFeatures, writeTest};
  return std::any_of(all.begin(), all.end(), [](const std::string& file) { return !file.empty(); });
}

ThesisFileRun prepareFileRun(const ThesisFileOptions& files, const Robot& robot, std::size_t sets, std::uint64_t seed) {
  const std::vector<std::string> names = programJoints();
  const JointColumns offsets{robot, names, widestOffset}, angles{robot, names, widestAngle};
  ThesisFileRun run;
  if (!files.errors.empty()) {
    run.inputs.offsets =
        readInput(files.errors, "--errors", run, [&](const auto& file) { return readErrorSets(file, offsets); });
  }
  for (std::size_t set = 0; files.errors.empty() && set < sets; ++set) {
    run.inputs.offsets.push_back(drawProgramSet(names, seed, set));
  }
  const std::vector<Eigen::VectorXd> poses =
      files.poses.empty()
          ? programPoses(names)
          : readInput(files.poses, "--poses", run, [&](const auto& file) { return readPoses(file, angles); });
  run.inputs.heldOut = files.test.empty() ? selectHeldOutPoses(robot, names, programTestPoses)
                                          : readInput(files.test, "--test", run,
                                                      [&](const auto& file) { return readPoses(file, angles); });
  run.inputs.features = files.features.empty() ? std::vector{programGrid()}
                                               : readInput(files.features, "--features", run,
                                                           [](const auto& file) { return readFeatures(file); });
  for (const Eigen::VectorXd& pose : poses) {
    run.poses.push_back(anglesOfAll(robot, names, pose));
  }
  run.setting = {.feature = ThesisFeature::file,
                 .poses = poses.size(),
                 .jointNoise = AngleNoise::unrounded,
                 .samples = files.samples,
                 .choice = PoseChoice::file,
                 .errorSets = ErrorSets::file};
  writeOutputs(files, run, poses);
  return run;
}

} // namespace naocal
