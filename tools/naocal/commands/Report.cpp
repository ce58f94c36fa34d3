#include "commands/Commands.hpp"
#include "console/CommandLine.hpp"
#include "console/OutputFiles.hpp"
#include "console/print/PrintText.hpp"

#include "calibration/result/ResultFile.hpp"
#include "command-line/OptionChecks.hpp"
#include "diagnosis/CheckedCalibration.hpp"
#include "estimation/ModelBuilder.hpp"
#include "report/ReportPage.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/core.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

namespace {

struct ReportCommand {
  std::string file, output;
  std::vector<std::string> lookIn;
};

bool isCaptureSet(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path / "captures.json", ignored);
}

/// The result of the base model, as 'naocal solve' writes it.
nlohmann::json solveSet(const std::string& folder) {
  LoadedSets given = loadSets({folder}, false);
  const Measurements measurements = buildMeasurements(std::move(given.sets), given.robot);
  const Model model = buildModel(measurements);
  const CalibrationResult result = calibrateChecked(measurements, model);
  return resultJson({measurements, model, result}, given.inputs);
}

std::string renderPage(const ReportCommand& command) {
  const CaptureSources sources{{command.lookIn.begin(), command.lookIn.end()},
                               [](const std::string& sentence) { printText(stderr, "{}\n", sentence); }};
  if (isCaptureSet(command.file)) {
    return renderReport(solveSet(command.file), std::filesystem::path{command.file} / "result.json", sources);
  }
  return renderReport(command.file, sources);
}

} // namespace

void addReport(CLI::App& app) {
  auto command = std::make_shared<ReportCommand>();
  CLI::App* reporter = app.get_subcommand("report");
  reporter->footer("Example: naocal report result.json -o report.html");
  reporter
      ->add_option("FILE", command->file,
                   "a result of 'naocal solve', a diagnosis of 'naocal diagnose', what 'naocal evaluate thesis --json' "
                   "writes, or "
                   "the folder of a capture set, which is then solved with the base model")
      ->type_name("FILE")
      ->required();
  reporter->add_option("-o,--output", command->output, "the page to write")
      ->type_name("FILE")
      ->required()
      ->check(replaceableFile(std::string{pageFormat}));
  addLookIn(*reporter, command->lookIn);
  reporter->callback([command] {
    const std::string page = renderPage(*command);
    writePage(command->output, page);
    printText("written to {} ({:.1f} MB): open it in any browser\n", command->output, 1e-6 * double(page.size()));
  });
}

} // namespace naocal
