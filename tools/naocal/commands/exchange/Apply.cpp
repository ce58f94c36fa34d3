#include "commands/Commands.hpp"
#include "console/OutputFiles.hpp"
#include "console/RecordApplied.hpp"
#include "console/RobotCalibrationFile.hpp"
#include "console/print/PrintText.hpp"

#include "command-line/OptionChecks.hpp"
#include "dialects/ModelCalibration.hpp"
#include "dialects/SavedCalibration.hpp"
#include "framework/configuration/Configuration.hpp"
#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace naocal {

namespace {

using nlohmann::json;

struct ApplyCommand {
  std::string result, configuration, location, json, state;
  RobotNames names;
  PostureOptions posture;
  bool undo = false, dryRun = false;
};

/// The folder's own files, over naocal's where it has no defaults of its own (a robot's state folder).
ConfigurationFolders foldersOf(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder / "location")) {
    throw InputError{fmt::format("{}: expected a configuration with the folder location, as in HULKs' "
                                 "home/configuration or a robot's state folder, found none",
                                 folder.string())};
  }
  const bool isWhole =
      std::filesystem::exists(folder / "location/default/body/default/JointCalibrationProvider.json") &&
      std::filesystem::exists(folder / "location/default/head/default/Projection.json");
  return {isWhole ? folder : configurationDirectory(), folder};
}

/// Names of the robot's head and body, from the options or from the captures' serial numbers; the location from the
/// option or from sdk.json.
RobotNames namesOf(const ApplyCommand& command, const RobotCalibration& calibration,
                   const ConfigurationFolders& folders) {
  const bool hasMap = std::filesystem::exists(folders.saved / "location/default/id_map.json");
  RobotNames names = findRobotNames(hasMap ? folders.saved : folders.shipped, calibration.headId, calibration.bodyId);
  names.head = command.names.head.empty() ? names.head : command.names.head;
  names.body = command.names.body.empty() ? names.body : command.names.body;
  if (names.head.empty() || names.body.empty()) {
    throw InputError{
        fmt::format("{}: expected captures that say which robot it is, found none; name it with --head and "
                    "--body, or the captures with --set",
                    command.result)};
  }
  names.location = command.location;
  const Overlay sdk{layerFiles(folders, "sdk.json", RobotPart::none, {})};
  if (names.location.empty() && sdk.merged->contains("location") && (*sdk.merged)["location"].is_string()) {
    names.location = (*sdk.merged)["location"].get<std::string>();
  }
  return names;
}

/// The robot of the configuration; serial numbers are the captures', and unknown for a part that an option names.
RunRobot robotOf(const ApplyCommand& command, const RobotNames& names, const RobotCalibration& calibration) {
  return {names.body, names.head, command.names.body.empty() ? calibration.bodyId : "",
          command.names.head.empty() ? calibration.headId : ""};
}

/// Sets joints, mounts, and lenses that the calibration estimated.
void setAll(const LoadedCalibration& loaded, Configuration& configuration) {
  std::vector<EffectiveOffset> offsets;
  for (const auto& [joint, offset] : loaded.calibration.offsets) {
    offsets.push_back({joint, offset, 0, 1});
  }
  StoredResult mounts;
  mounts.values = valuesFromCalibration(loaded.calibration, {});
  for (const auto& [name, camera] : loaded.calibration.cameras) {
    if (camera.rotation) {
      mounts.terms.push_back("cameraRotation@" + name);
    }
  }
  applyCalibration(offsets, mounts, configuration);
  for (const auto& [name, camera] : loaded.calibration.cameras) {
    if (camera.lens && (loaded.lensIsEstimated || loaded.result.terms.empty())) {
      applyLens(name, *camera.lens, configuration);
    }
  }
}

/// Keys whose values differ: by mount and key, [before, after].
json differences(const std::string& before, const std::string& after) {
  const json old = json::parse(before), now = json::parse(after);
  json changes = json::object();
  for (const auto& [mount, keys] : now.items()) {
    for (const auto& [key, value] : keys.items()) {
      const json& previous = old[mount].contains(key) ? old[mount][key] : json{};
      if (previous != value) {
        changes[mount][key] = {previous, value};
      }
    }
  }
  return changes;
}

std::string shortNumber(const json& value) {
  if (!value.is_array()) {
    return value.is_number() ? fmt::format("{:.4f}", value.get<double>()) : value.dump();
  }
  std::vector<std::string> parts;
  for (const json& part : value) {
    parts.push_back(shortNumber(part));
  }
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

void printDifferences(const json& changes) {
  for (const auto& [mount, keys] : changes.items()) {
    printText("{} [{}]\n", mount, mount.starts_with("Motion") ? "degrees" : "radians; lens: shares of the picture");
    for (const auto& [key, values] : keys.items()) {
      printText("  {:<16} {:>28} -> {}\n", key, shortNumber(values[0]), shortNumber(values[1]));
    }
  }
}

std::vector<std::string> targetsOf(const Configuration& configuration) {
  std::vector<std::string> files;
  for (const Configuration::Mount& mount : configuration.mounts()) {
    files.push_back(configuration.saveTarget(mount.name).string());
  }
  return files;
}

/// Changes or restores the configuration; returns what differs.
json change(const ApplyCommand& command, const LoadedCalibration& loaded, Configuration& configuration) {
  const std::string before = snapshotCalibration(configuration);
  if (command.undo) {
    if (command.dryRun) {
      throw InputError{"--undo restores the files from before the last save; it has no --dry-run"};
    }
    undoCalibration(configuration);
  } else {
    setAll(loaded, configuration);
  }
  return differences(before, snapshotCalibration(configuration));
}

/// Of a dry run: only a save that was cut off makes the configuration write.
void refuseToWrite(const std::filesystem::path& file, std::string_view) {
  throw InputError{fmt::format("{}: expected the result of a whole save, found one that was cut off; apply without "
                               "--dry-run, or a start of naocal-robot, completes it",
                               file.string())};
}

void apply(const ApplyCommand& command) {
  PostureOptions posture = command.posture;
  posture.force |= command.undo; // writes nothing of the result
  const LoadedCalibration loaded = loadCalibration(command.result, posture);
  const ConfigurationFolders folders = foldersOf(command.configuration);
  try {
    const RobotNames names = namesOf(command, loaded.calibration, folders);
    Configuration configuration{folders, names, command.dryRun ? refuseToWrite : writeAtomically,
                                [](std::string_view line) { printText(stderr, "{}\n", line); }};
    mountCalibration(configuration);
    const ConfiguredBefore before = readBefore(configuration);
    const json changes = change(command, loaded, configuration);
    const std::vector<std::string> files = targetsOf(configuration);
    if (command.json != "-") {
      if (!command.undo) {
        printCompensations(loaded);
      }
      printText("body {}, head {}: {}\n", names.body, names.head,
                changes.empty() ? "nothing changes" : "before -> after");
      printDifferences(changes);
      std::fflush(stdout);
    }
    if (!command.undo && !command.dryRun) {
      saveCalibration(configuration);
    }
    const std::string recorded =
        command.dryRun || changes.empty()
            ? ""
            : recordApplied({command.result, command.state, command.undo, robotOf(command, names, loaded.calibration)},
                            loaded, before, configuration);
    if (!command.json.empty()) {
      writeJson(withFormat("naocal-apply", {{"body", names.body},
                                            {"head", names.head},
                                            {"changes", changes},
                                            {"joints", compensationsJson(loaded)},
                                            {"files", files},
                                            {"written", !command.dryRun && !changes.empty()}}),
                command.json);
    }
    if (command.json != "-" && !changes.empty()) {
      printText("{}: {}\n",
                command.undo     ? "restored"
                : command.dryRun ? "would be written"
                                 : "written",
                fmt::join(files, ", "));
      if (!recorded.empty()) {
        printText("recorded: {}; see 'naocal history {}'\n", recorded, names.body);
      }
    }
  } catch (const ConfigurationError& error) {
    throw InputError{error.what()};
  }
}

} // namespace

void addApply(CLI::App& app, int& exitCode) {
  auto command = std::make_shared<ApplyCommand>();
  CLI::App* applier = app.get_subcommand("apply");
  applier->footer(
      "Example: naocal apply result.json --configuration home/configuration\n"
      "Shows what changes, then writes both files or none.\n"
      "Joints that are less than 50 % learned keep their values. A result that should not be used is refused\n"
      "(exit code 3, the reasons on standard error).\n"
      "To take effect: copy the files to the robot if they are elsewhere, then restart naocal-robot.");
  applier->add_option("RESULT", command->result, "a result of 'naocal solve', or a file of 'naocal import'")
      ->type_name("FILE")
      ->required();
  applier->add_option("--configuration", command->configuration, "folder with location/ in it")
      ->type_name("FOLDER")
      ->required();
  applier->add_flag("--undo", command->undo, "restore both files as they were before the last save");
  applier->add_flag("--dry-run", command->dryRun, "show what would change and write nothing");
  addPostureOptions(*applier, command->posture);
  applier->add_option("--head", command->names.head, "the head's name; default: by id_map.json from its serial number")
      ->type_name("NAME")
      ->group(expertOptions);
  applier->add_option("--body", command->names.body, "the body's name; default: by id_map.json from its serial number")
      ->type_name("NAME")
      ->group(expertOptions);
  applier->add_option("--location", command->location, "folder below location/; default: that of sdk.json")
      ->type_name("NAME")
      ->group(expertOptions);
  applier->add_option("--state", command->state, stateHelp)->type_name("FOLDER")->group(expertOptions);
  applier->add_option("--json", command->json, "write what changes as JSON to a file, or - for standard output")
      ->type_name("FILE")
      ->check(replaceableFile("naocal-apply"));
  applier->callback([command, &exitCode] { exitCode = writeUnlessRefused([&] { apply(*command); }); });
}

} // namespace naocal
