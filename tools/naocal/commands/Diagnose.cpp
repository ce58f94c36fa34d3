#include "commands/Commands.hpp"
#include "console/CommandLine.hpp"
#include "console/OutputFiles.hpp"
#include "console/Progress.hpp"
#include "console/print/PrintDiagnosis.hpp"
#include "console/print/PrintFindings.hpp"
#include "console/print/PrintText.hpp"

#include "command-line/OptionChecks.hpp"
#include "diagnosis/DiagnosisFile.hpp"
#include "diagnosis/FoldErrors.hpp"
#include "diagnosis/OwnEffect.hpp"
#include "estimation/ModelFile.hpp"
#include "io/InputError.hpp"
#include "poses/PoseFile.hpp"
#include "scenes/SceneNextPoses.hpp"
#include "setups/Mending.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

struct DiagnoseCommand {
  std::vector<std::string> sets;
  std::string json, model, poses, own, failOn;
  std::string definitions = "[]"; // of the model's file
  bool skipBad = false, samePlace = false, full = false;
  DiagnosisOptions options;
  NextPosesOptions next;
  std::size_t folds = 0; // 0: no cross-validation
};

/// Errors on poses that were not fitted, printed and as JSON.
nlohmann::json validate(const DiagnoseCommand& command, const Measurements& measurements, const Diagnosis& diagnosis) {
  std::vector<std::string> suggested = diagnosis.suggested;
  if (diagnosis.own) {
    suggested.pop_back();
  }
  const FoldErrors errors =
      predictFolds(*measurements.sets, measurements.robot, command.samePlace, command.folds,
                   {command.options.with, command.options.without, suggested, command.options.calibration.effects});
  if (command.json != "-") {
    const auto size = [](const PredictionErrors& error) {
      return error.pixels.empty() ? formatSizes(summarizeReadings(error.readings))
                                  : fmt::format("{:.2f} px", summarizeLengths(error.pixels).rms);
    };
    printText("on poses that were not fitted ({} folds): {}; with what is suggested {}\n", errors.folds,
              size(errors.given), size(errors.suggested));
  }
  return toJson(errors);
}

/// Adds a model file's terms and effects to what the command line gave.
void readModel(DiagnoseCommand& command, const Robot& robot) {
  if (command.model.empty()) {
    return;
  }
  ModelFile file = readModelFile(command.model, robot);
  DiagnosisOptions& options = command.options;
  options.with.insert(options.with.end(), file.with.begin(), file.with.end());
  options.without.insert(options.without.end(), file.without.begin(), file.without.end());
  options.calibration.effects = std::move(file.effects);
  command.definitions = file.definitions;
}

/// Proposes the next poses; only the open questions if no poses are needed.
NextPoses asked(const DiagnoseCommand& command, const Measurements& measurements, const Diagnosis& diagnosis) {
  NextPosesOptions options = command.next;
  options.count = command.json.empty() && command.poses.empty() ? 0 : options.count;
  options.seed = command.options.calibration.candidateTests.seed;
  return proposeSceneNextPoses(measurements, diagnosis, command.options, options);
}

/// The unexplained curve, if an expression fits it; otherwise nullptr.
const DriverCurve* beyondTheCatalogue(const Diagnosis& diagnosis) {
  return diagnosis.verdict == Verdict::unknownEffect && !diagnosis.driverCurves.empty() &&
                 !diagnosis.driverCurves.front().coefficients.empty()
             ? &diagnosis.driverCurves.front()
             : nullptr;
}

/// The requested model, extended by the suggested effects and the curve as a custom effect.
nlohmann::json modelWith(const DriverCurve& curve, const DiagnoseCommand& command, const Diagnosis& diagnosis) {
  std::vector<std::string> with = command.options.with;
  with.insert(with.end(), diagnosis.suggested.begin(), diagnosis.suggested.end());
  nlohmann::json effect = curveAsUserEffect(curve), define = nlohmann::json::parse(command.definitions);
  if (!diagnosis.own) {
    with.push_back(fmt::format("{}@{}", effect["name"].get<std::string>(), curve.place));
  }
  define.push_back(std::move(effect));
  return modelFileJson(with, command.options.without, std::move(define));
}

/// Diagnoses with progress output; Ctrl-C stops with the findings so far.
Diagnosis withProgress(const Measurements& measurements, DiagnosisOptions options) {
  const Progress progress{"models tested (at most)"};
  const std::size_t most = 2 + measurements.poses.size() / 4;
  std::size_t done = 0;
  options.shouldContinue = [&](std::size_t) { return progress(std::min(++done, most - 1), most); };
  Diagnosis diagnosis = diagnose(measurements, options);
  progress(most, most);
  return diagnosis;
}

int diagnose(DiagnoseCommand& command) {
  command.options.with = joinLabels(command.options.with);
  const GivenOptions asIs{command.sets,  command.options.with, command.options.without,
                          command.model, command.samePlace,    command.skipBad};
  LoadedSets given = loadSets(command.sets, command.skipBad);
  readModel(command, given.robot);
  mendSetUps(command.options.with, given.robot, given.sets);
  const Measurements measurements = buildMeasurements(std::move(given.sets), given.robot, command.samePlace);
  const Diagnosis diagnosis = withProgress(measurements, command.options);
  const NextPoses next = asked(command, measurements, diagnosis);
  const nlohmann::json validated =
      command.folds > 0 ? validate(command, measurements, diagnosis) : nlohmann::json(nullptr);
  if (!command.json.empty()) {
    nlohmann::json json = diagnosisJson(diagnosis, command.full ? allOfThem : drawable);
    json["next"] = nextPosesJson(next, given.robot);
    if (command.folds > 0) {
      json["crossValidated"] = validated;
    }
    json["inputs"] = toJson(given.inputs.placedBeside(command.json));
    writeJson(json, command.json);
  }
  if (!command.poses.empty() && !next.poses.empty()) {
    writeJson(posesJson(next, given.robot), command.poses);
  }
  const DriverCurve* beyond = beyondTheCatalogue(diagnosis);
  if (beyond && !command.own.empty()) {
    writeJson(modelWith(*beyond, command, diagnosis), command.own);
  }
  if (command.json != "-") {
    printDiagnosis(diagnosis, asIs);
    if (beyond || !command.own.empty()) {
      printOwnEffectHint(beyond, diagnosis, asIs, command.own);
    }
    printNextPoses(next, asIs, command.poses);
  }
  return diagnosis.verdict == Verdict::badCaptures || failsOn(command.failOn, diagnosis.findings) ? 3 : 0;
}

} // namespace

void addDiagnose(CLI::App& app, int& exitCode) {
  auto command = std::make_shared<DiagnoseCommand>();
  CLI::App* diagnoser = app.get_subcommand("diagnose");
  diagnoser->footer("Example: naocal diagnose captures/ --json diagnosis.json --next poses.json");
  diagnoser->add_option("SET", command->sets, "folders with captures.json")->type_name("FOLDER")->required();
  diagnoser->add_option("--json", command->json, "the diagnosis as JSON to a file, or - for standard output")
      ->type_name("FILE")
      ->check(replaceableFile("naocal-diagnosis"));
  diagnoser
      ->add_flag("--full", command->full,
                 fmt::format("all points of every figure in the JSON, not only {} of them", drawable))
      ->group(expertOptions);
  diagnoser->add_option("--with", command->options.with, "effects that are in the model already: EFFECT@PLACE")
      ->type_name("EFFECT@PLACE")
      ->delimiter(',');
  diagnoser->add_option("--without", command->options.without, "leave effects out")
      ->type_name("EFFECT@PLACE")
      ->delimiter(',');
  diagnoser->add_option("--model", command->model, "a model file: further terms, and effects of your own")
      ->type_name("FILE");
  diagnoser
      ->add_option("--own,--save-model", command->own,
                   "write the unexplained misfit, if an expression fits it, as a custom effect into this model file")
      ->type_name("FILE")
      ->group(expertOptions)
      ->check(replaceableFile("naocal-model"));
  addFailOn(*diagnoser, command->failOn);
  diagnoser->add_option("--next", command->poses, "write poses that would decide what is still open into this file")
      ->type_name("FILE")
      ->check(replaceableFile("naocal-poses"));
  diagnoser->add_option("--next-count", command->next.count, "number of poses for --next")
      ->group(expertOptions)
      ->check(wholeNumber(0, 100))
      ->capture_default_str();
  diagnoser
      ->add_option("--seed", command->options.calibration.candidateTests.seed,
                   "seed of the noise simulations and of the candidate poses")
      ->group(expertOptions)
      ->capture_default_str();
  diagnoser
      ->add_option("--draws", command->options.calibration.candidateTests.draws,
                   "number of noise simulations behind the false-alarm rate")
      ->group(expertOptions)
      ->check(wholeNumber(19, 100000))
      ->capture_default_str();
  diagnoser
      ->add_option("--folds", command->folds,
                   "cross-validate: predict each of K parts of the poses from a fit of the others (5 if no K is given)")
      ->type_name("[K]")
      ->expected(0, 1)
      ->default_str("5")
      ->check(wholeNumber(2, 1000));
  diagnoser->add_flag("--same-place", command->samePlace,
                      "boards and stances with the same id have the same placement in all sets");
  diagnoser->add_flag("--skip-bad", command->skipBad,
                      "use the other captures when some cannot be used, and list those");
  diagnoser->callback([command, &exitCode] { exitCode = diagnose(*command); });
}

} // namespace naocal
