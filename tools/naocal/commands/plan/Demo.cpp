#include "commands/Commands.hpp"
#include "console/CommandLine.hpp"
#include "console/OutputFiles.hpp"
#include "console/Progress.hpp"
#include "console/print/PrintCalibration.hpp"
#include "console/print/PrintDiagnosis.hpp"
#include "console/print/PrintText.hpp"

#include "command-line/OptionChecks.hpp"
#include "data/CaptureSetFile.hpp"
#include "detect/BoardDetector.hpp"
#include "diagnosis/DiagnosisFile.hpp"
#include "effects/Catalogue.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/Units.hpp"
#include "report/ReportPage.hpp"
#include "simulation/SimulatedPictures.hpp"
#include "simulation/StandingPoses.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <thread>

namespace naocal {

namespace {

struct DemoCommand {
  std::string folder = (std::filesystem::temp_directory_path() / "naocal-demo").string();
  std::uint64_t seed = 1;
  std::size_t poses = 12;
};

unsigned threads() {
  return std::max(1u, std::thread::hardware_concurrency());
}

/// Simulates an uncalibrated robot and renders images of four boards. Absent if interrupted.
std::optional<Simulation> robotWithPictures(const DemoCommand& command, const Robot& robot, const std::string& folder) {
  SimulationPlan plan;
  plan.images = true;
  plan.hiddenFlaw = true;
  plan.repeatKind = RepeatKind::reapproach;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, command.poses, command.seed);
  Simulation simulation = simulate(robot, plan, command.seed);
  const Progress progress{"pictures taken"};
  const std::size_t all = simulation.set.captures.size();
  const std::size_t taken = renderPictures(picturesOf(simulation), Appearance{}, command.seed, folder, threads(),
                                           [&](std::size_t done) { return progress(done, all); });
  return taken == all ? std::optional{std::move(simulation)} : std::nullopt;
}

/// Prints truth and estimates; returns how many true values lie inside their 95 % intervals, and the number of values.
std::pair<std::size_t, std::size_t> printTruth(const Truth& truth, const Model& model,
                                               const CalibrationResult& result) {
  printText("\n  {:<34} {:>12} {:>12} {:>11}\n", "unknown", "truth", "estimate", "± 1 sigma");
  std::size_t inside = 0, all = 0;
  for (const Term& term : model.terms()) {
    for (std::size_t i = 0; i < term.effect.unknowns.size() && term.requested; ++i) {
      const Unknown& unknown = term.effect.unknowns[i];
      const auto value = truth.value(term.effect.name, term.placeName, unknown.name);
      if (!value) {
        continue;
      }
      const Estimate& estimate = result.estimates[term.first + i];
      const auto [low, high] = estimate.interval();
      const bool isInside = low <= *value && *value <= high;
      ++all;
      inside += isInside;
      const auto [unit, scale] = displayUnit(unknown.unit);
      printText("  {:<34} {:>9.3f}{:<6} {:>9.3f}    {:>8.3f}{}\n",
                term.effect.name == effectName::jointOffset ? term.placeName : term.label() + " " + unknown.name,
                scale * *value, appendUnit("", unit), scale * estimate.best(), scale * estimate.bestSigma(),
                isInside ? "" : "  outside 95 %");
    }
  }
  return {inside, all};
}

/// Renders images, detects corners and writes the set; false if interrupted.
bool takeCaptures(const DemoCommand& command, const Robot& robot, const std::string& set, Truth& truth) {
  auto simulation = robotWithPictures(command, robot, set);
  if (!simulation) {
    return false;
  }
  CaptureSet captures = simulation->set;
  {
    const Progress progress{"pictures searched for corners"};
    detectInSet(captures, set, threads(), [&](std::size_t done, std::size_t all) { return progress(done, all); });
  }
  if (Progress::wasInterrupted()) {
    return false;
  }
  writeCaptureSet(captures, set);
  writeAtomically(truthPath(set), formatTruth(simulation->truth));
  truth = simulation->truth;
  return true;
}

int demo(const DemoCommand& command) {
  const std::filesystem::path folder{command.folder};
  const std::string set = (folder / "captures").string();
  requireReplaceableSet(set);
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  printText("A simulated {} with joints off by up to 6.5° and cameras by up to 2° looks at four printed boards.\n"
            "Something else in its leg is not as drawn. What is it?\n",
            robot.model);
  Truth truth;
  if (!takeCaptures(command, robot, set, truth)) {
    printText("stopped\n");
    return 0;
  }
  const LoadedSets given = loadSets({set}, false);
  const Measurements measurements = buildMeasurements(given.sets, given.robot);
  const Diagnosis diagnosis = diagnose(measurements);
  const std::string diagnosisFile = (folder / "diagnosis.json").string(),
                    whyFile = (folder / "diagnosis.html").string();
  writeJson(diagnosisJson(diagnosis), diagnosisFile);
  writePage(whyFile, renderReport(diagnosisFile));
  printDiagnosis(diagnosis, {.sets = {set}});

  const Model model = buildModel(measurements, diagnosis.with);
  const CalibrationResult result = calibrate(measurements, model);
  const std::string resultFile = (folder / "result.json").string(), reportFile = (folder / "report.html").string();
  writeJson(resultJson({measurements, model, result}, given.inputs.placedBeside(resultFile)), resultFile);
  printText("\nCalibrated {}:\n", diagnosis.suggested.empty() ? "as it is, nothing added" : "with that added");
  printCalibration({measurements, model, result});
  const TrueEffect& hidden = truth.effects.back();
  printText("\nNow the truth is opened. Hidden was {}@{}.\n", hidden.effect, hidden.at);
  const auto [inside, all] = printTruth(truth, model, result);
  printText("\n{} of {} true values lie within their 95 % intervals.\n", inside, all);
  writePage(reportFile, renderReport(resultFile));
  printText("captures: {}\nresult:   {}\nreports (open them in any browser):\n  what was missing: {}\n  the "
            "calibration:  {}\n",
            set, resultFile, whyFile, reportFile);
  return result.usable ? 0 : 3;
}

} // namespace

void addDemo(CLI::App& app, int& exitCode) {
  auto command = std::make_shared<DemoCommand>();
  CLI::App* demonstration = app.get_subcommand("demo");
  demonstration->footer("Example: naocal demo --seed 7");
  demonstration->add_option("-o,--output", command->folder, "the folder to write into")
      ->type_name("FOLDER")
      ->capture_default_str();
  demonstration->add_option("--seed", command->seed, "another robot for every seed")->capture_default_str();
  demonstration->add_option("--poses", command->poses, "how many poses the robot takes")
      ->check(wholeNumber(3, 100))
      ->capture_default_str();
  demonstration->callback([command, &exitCode] { exitCode = demo(*command); });
}

} // namespace naocal
