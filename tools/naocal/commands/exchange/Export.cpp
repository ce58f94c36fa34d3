#include "commands/Commands.hpp"
#include "console/HeadExport.hpp"
#include "console/RobotCalibrationFile.hpp"
#include "console/UrdfExport.hpp"
#include "console/print/PrintText.hpp"

#include "command-line/OptionChecks.hpp"
#include "dialects/Dialects.hpp"
#include "dialects/UrdfCorrection.hpp"
#include "dialects/heads/DialectNames.hpp"
#include "dialects/heads/HeadDialects.hpp"
#include "io/Files.hpp"
#include "io/Folders.hpp"
#include "io/InputError.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <memory>
#include <string>
#include <vector>

namespace naocal {

namespace {

struct ExportCommand {
  std::string result, dialect, output, camera;
  PostureOptions posture;
};

/// Calibration in the files that are already there, which are about to be replaced. Throws InputError if one of them is
/// no file of this dialect or holds more than a calibration.
RobotCalibration readPresent(const Dialect& dialect, const std::vector<DialectFile>& files,
                             const std::filesystem::path& folder, const Robot& robot) {
  ParsedCalibration present;
  for (const DialectFile& file : files) {
    const std::filesystem::path path = folder / file.name;
    if (!std::filesystem::exists(path)) {
      continue;
    }
    const ParsedCalibration one = dialect.parse(readFile(path), path.string(), robot);
    if (!one.unused.empty()) {
      throw InputError{
          fmt::format("{}: expected a file with nothing but a calibration to replace, found also {}; it is "
                      "left alone, name another folder and copy the numbers",
                      path.string(), fmt::join(one.unused, ", "))};
    }
    addCalibration(one, path.string(), present);
  }
  return present.calibration;
}

void printRemarks(const Dialect& dialect, const LoadedCalibration& loaded, const RobotCalibration& written) {
  std::vector<std::string> zero;
  for (const std::string_view joint : offsetJoints()) {
    if (dialect.namesAllJoints && !written.offsets.empty() && !written.offsets.contains(std::string{joint})) {
      zero.emplace_back(joint);
    }
  }
  if (!zero.empty()) {
    printText("written as 0, for want of a number: {}\n", fmt::join(zero, ", "));
  }
  const std::vector<std::string> lost = unwritten(dialect, written, loaded.robot);
  if (!lost.empty()) {
    printText("{} has no place for: {}\n", dialect.name, fmt::join(lost, ", "));
  }
}

void exportCalibration(const ExportCommand& command) {
  const Dialect& dialect = findDialect(command.dialect);
  const LoadedCalibration loaded = loadCalibration(command.result, command.posture);
  std::vector<DialectFile> files = dialect.write(loaded.calibration, loaded.robot);
  const RobotCalibration all =
      completeCalibration(loaded.calibration, readPresent(dialect, files, command.output, loaded.robot));
  files = dialect.write(all, loaded.robot);
  if (files.empty()) {
    throw InputError{fmt::format("{}: expected something that {} has a place for, found nothing{}", command.result,
                                 dialect.name,
                                 dialect.hasJoints ? "" : "; lenses come from the captures: name them with --set")};
  }
  printCompensations(loaded);
  printRemarks(dialect, loaded, all);
  createFolders(command.output);
  for (const DialectFile& file : files) {
    const std::filesystem::path path = std::filesystem::path{command.output} / file.name;
    writeAtomically(path, file.text);
    printText("written: {}\n", path.string());
  }
}

std::string dialectHelp() {
  std::string text;
  for (const Dialect& dialect : dialects()) {
    text += fmt::format("\n  {:<14} {}", dialect.name, dialect.what);
  }
  text += fmt::format("\n  {:<14} {}", urdfDialect, "the URDF with corrected joint origins, and the offsets as YAML");
  text += "\nThe direction of a head's camera, changed in the other program's file (-o FILE):";
  for (const HeadDialect& dialect : headDialects()) {
    text += fmt::format("\n  {:<14} {}", dialect.name, dialect.what);
  }
  return text;
}

} // namespace

void addExport(CLI::App& app, int& exitCode) {
  auto command = std::make_shared<ExportCommand>();
  CLI::App* exporter = app.get_subcommand("export");
  exporter->footer("Example: naocal export result.json --to bhuman -o Config/Robots/nao21\nDialects:" + dialectHelp());
  exporter->add_option("RESULT", command->result, "a result of 'naocal solve', or a file of 'naocal import'")
      ->type_name("FILE")
      ->required();
  exporter->add_option("--to", command->dialect, "the other program, as listed below")
      ->type_name("DIALECT")
      ->check(oneOf(exportedDialects()))
      ->required();
  exporter
      ->add_option("-o,--output", command->output,
                   "folder to write to; joints that are less than 50 % learned keep the values of files there; for the "
                   "direction of a head's camera the file to change")
      ->type_name("FOLDER")
      ->required();
  exporter->add_option("--camera", command->camera, "the head's camera, where the robot carries several")
      ->type_name("NAME");
  addPostureOptions(*exporter, command->posture);
  exporter->callback([command, &exitCode] {
    exitCode = writeUnlessRefused([&] {
      if (const HeadDialect* head = findHeadDialect(command->dialect)) {
        exportHead(*head, command->result, command->posture, command->camera, command->output);
      } else if (command->dialect == urdfDialect) {
        exportUrdf(command->result, command->posture, command->output);
      } else {
        exportCalibration(*command);
      }
    });
  });
}

} // namespace naocal
