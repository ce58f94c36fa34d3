#include "commands/Commands.hpp"
#include "console/HeadExport.hpp"
#include "console/OutputFiles.hpp"
#include "console/print/PrintText.hpp"

#include "command-line/OptionChecks.hpp"
#include "dialects/Dialects.hpp"
#include "dialects/heads/DialectNames.hpp"
#include "dialects/heads/HeadDialects.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace naocal {

namespace {

struct ImportCommand {
  std::vector<std::string> files;
  std::string dialect, output, robot = "V6", set, camera;
};

void printImported(const RobotCalibration& calibration) {
  std::vector<std::string> joints;
  for (const std::string_view joint : offsetJoints()) {
    joints.emplace_back(joint);
  }
  if (!calibration.robot.empty()) {
    joints.clear();
    for (const auto& [joint, offset] : calibration.offsets) {
      joints.push_back(joint);
    }
  }
  for (const std::string& joint : joints) {
    const auto offset = calibration.offsets.find(joint);
    if (offset != calibration.offsets.end() && offset->second != 0) {
      printText("  {:<16} {:>9.4f}°\n", joint, degrees(offset->second));
    }
  }
  for (const auto& [name, camera] : calibration.cameras) {
    if (camera.rotation) {
      const Eigen::Vector3d angles = *camera.rotation * degrees(1.0);
      printText("  camera {:<9} turned by {:.4f}°, {:.4f}°, {:.4f}° about x, y, z\n", name, angles.x(), angles.y(),
                angles.z());
    }
    if (camera.translation) {
      const Eigen::Vector3d shift = *camera.translation * 1000;
      printText("  camera {:<9} shifted by {:.2f}, {:.2f}, {:.2f} mm\n", name, shift.x(), shift.y(), shift.z());
    }
    if (camera.lens) {
      printText("  camera {:<9} {} x {} px, fx {:.2f}, fy {:.2f}, cx {:.2f}, cy {:.2f}\n", name, camera.lens->width,
                camera.lens->height, camera.lens->fx, camera.lens->fy, camera.lens->cx, camera.lens->cy);
    }
  }
}

void requireOption(bool isGiven, const char* name) {
  if (!isGiven) {
    throw CLI::RequiredError{name};
  }
}

ParsedCalibration readFiles(const ImportCommand& command) {
  ParsedCalibration all;
  if (const HeadDialect* head = findHeadDialect(command.dialect)) {
    requireOption(!command.set.empty(), "--set");
    if (command.files.size() != 1) {
      throw InputError{
          fmt::format("{}: expected one file of {}, found {}", command.files[1], head->name, command.files.size())};
    }
    return importHead(*head, command.files.front(), command.set, command.camera);
  }
  const Dialect& dialect = findDialect(command.dialect);
  const Robot robot = loadRobot(configurationDirectory(), command.robot);
  for (const std::string& file : command.files) {
    addCalibration(dialect.parse(readFile(file), file, robot), file, all);
  }
  return all;
}

void importCalibration(const ImportCommand& command) {
  requireOption(!command.files.empty(), "FILE");
  requireOption(!command.dialect.empty(), "--from");
  requireOption(!command.output.empty(), "--output");
  const ParsedCalibration all = readFiles(command);
  writeJson(calibrationJson(all.calibration), command.output);
  if (command.output == "-") {
    return;
  }
  printImported(all.calibration);
  for (const std::string& what : all.unused) {
    printText("not used: {}\n", what);
  }
  printText("written to {}; next: naocal solve CAPTURES -o result.json --start {}\n", command.output, command.output);
}

} // namespace

void addImport(CLI::App& app) {
  auto command = std::make_shared<ImportCommand>();
  CLI::App* importer = app.get_subcommand("import");
  importer->footer("Example: naocal import jointCalibration.cfg cameraCalibration.cfg --from bhuman -o start.json");
  importer->add_option("FILE", command->files, "files of one robot, at most one of each kind")->type_name("FILE");
  importer->add_option("--from", command->dialect, "the other program")
      ->type_name("DIALECT")
      ->check(oneOf(importedDialects()));
  importer->add_option("-o,--output", command->output, "write the calibration to this file, or - for standard output")
      ->type_name("FILE")
      ->check(replaceableFile("naocal-calibration"));
  importer->add_option("--robot", command->robot, "the robot's model, for its mounts")
      ->capture_default_str()
      ->check(oneOf(std::vector<std::string>{"V4", "V5", "V6"}));
  importer
      ->add_option("--set", command->set,
                   "captures of the robot, for its camera's mount: where the file has the direction of a head's camera")
      ->type_name("SET");
  importer->add_option("--camera", command->camera, "the head's camera, where the robot carries several")
      ->type_name("NAME");
  importer->require_subcommand(0, 1);
  addRecordingImports(*importer);
  importer->callback([command, importer] {
    if (importer->get_subcommands().empty()) { // else done by it
      importCalibration(*command);
    }
  });
}

} // namespace naocal
