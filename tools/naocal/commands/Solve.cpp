#include "commands/Commands.hpp"
#include "console/CommandLine.hpp"
#include "console/OutputFiles.hpp"
#include "console/print/PrintCalibration.hpp"
#include "console/print/PrintFindings.hpp"
#include "console/print/PrintText.hpp"

#include "calibration/result/Verdict.hpp"
#include "command-line/OptionChecks.hpp"
#include "diagnosis/CheckedCalibration.hpp"
#include "diagnosis/anomalies/DataChecks.hpp"
#include "dialects/ModelCalibration.hpp"
#include "estimation/ModelBuilder.hpp"
#include "estimation/ModelFile.hpp"
#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/JsonReader.hpp"
#include "setups/Mending.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

namespace {

struct SolveCommand {
  std::vector<std::string> sets, with, without;
  std::string output, json, model, start;
  std::string failOn;
  bool samePlace = false, skipBad = false, fixedNoise = false, plain = false;
  CalibrationOptions options;
};

/// The model from the options and the model file.
ModelFile askedModel(const SolveCommand& command, const Robot& robot) {
  ModelFile asked{.effects = allEffects()};
  if (!command.model.empty()) {
    asked = readModelFile(command.model, robot);
  }
  asked.with.insert(asked.with.end(), command.with.begin(), command.with.end());
  asked.without.insert(asked.without.end(), command.without.begin(), command.without.end());
  return asked;
}

/// The start from a result, or from a file of `naocal import`.
SearchStart readStart(const std::string& file, const Measurements& measurements, const Model& model) {
  const auto document = parseJson(readFile(file), file);
  const bool isResult = document.is_object() && document.value("format", nlohmann::json{}) == "naocal-result";
  return startAt(isResult ? parseResult(document, file).values
                          : valuesFromCalibration(parseCalibration(document, file), measurements.sets->front().cameras),
                 measurements, model);
}

/// Says how to mend mistakes of the set-up.
void printMending(const std::vector<WrongSetUp>& setUps, const GivenOptions& asIs) {
  for (const WrongSetUp& setUp : setUps) {
    printText("ask: {}\n", setUp.question);
  }
  printText("mend it:  naocal solve {} -o result.json\n", asIs.commandLine(labelsOf(setUps)));
}

/// The result of captures that cannot be fitted as they are: what is wrong with them, and no estimates.
nlohmann::json unfittedJson(const WrongSetUpError& error, const ResultSources& inputs) {

  return withFormat("naocal-result", {{"converged", false},
                                      {"verdict", toString(ResultVerdict::doNotUse)},
                                      {"usable", false},
                                      {"sentence", error.what()},
                                      {"setUps", setUpsJson(error.setUps)},
                                      {"suspicious", suspiciousJson(suspect(error.setUps))},
                                      {"findings", toJson(error.findings)},
                                      {"warnings", sentencesOf(furtherFindings(error.findings))},
                                      {"effects", nlohmann::json::array()},
                                      {"placements", nlohmann::json::object()},
                                      {"inputs", toJson(inputs)}});
}

int solve(SolveCommand& command) {
  const GivenOptions asIs{command.sets,  command.with,      command.without,
                          command.model, command.samePlace, command.skipBad};
  command.with = joinLabels(command.with);
  command.options.estimateNoise = !command.fixedNoise;
  command.options.robust = !command.plain;
  const bool isQuiet = command.json == "-" || command.output == "-"; // standard output is the result
  LoadedSets given = loadSets(command.sets, command.skipBad);
  ModelFile asked = askedModel(command, given.robot);
  given.inputs.setUps = mendSetUps(asked.with, given.robot, given.sets);
  if (!isQuiet && !given.inputs.setUps.empty()) {
    printText("captures changed before the fit: {}\n", fmt::join(given.inputs.setUps, ", "));
  }
  const Measurements measurements = buildMeasurements(std::move(given.sets), given.robot, command.samePlace);
  const Model model = buildModel(measurements, asked.with, asked.without, asked.effects);
  command.options.effects = std::move(asked.effects);
  if (!command.start.empty()) {
    SearchStart start = readStart(command.start, measurements, model);
    command.options.start = std::move(start.unknowns);
    if (!isQuiet) {
      printText("starts at {} numbers of {}{}{}\n", start.count, command.start,
                start.unused.empty() ? "" : "; not in this model: ", fmt::join(start.unused, ", "));
    }
  }
  const auto write = [&](const auto& documentFrom) {
    for (const std::string& file : {command.output, command.json}) {
      if (!file.empty()) {
        writeJson(documentFrom(given.inputs.placedBeside(file)), file);
      }
    }
  };
  CalibrationResult result;
  try {
    result = calibrateChecked(measurements, model, command.options);
  } catch (const WrongSetUpError& error) {
    write([&](const ResultSources& inputs) { return unfittedJson(error, inputs); });
    if (!isQuiet) {
      printFindings(error.findings);
      printText("These captures cannot be fitted as they are.\n");
      printMending(error.setUps, asIs);
    }
    return 3;
  }
  write([&](const ResultSources& inputs) { return resultJson({measurements, model, result}, inputs); });
  if (!isQuiet) {
    printCalibration({measurements, model, result});
    if (!result.setUps.empty()) {
      printMending(result.setUps, asIs);
    } else if (result.verdict != ResultVerdict::good && result.findings.front().isVerdict) {
      printText("find it:  naocal diagnose {}\n", asIs.commandLine());
    }
    if (!command.output.empty()) {
      printText("written to {}\n", command.output);
    }
  }
  return result.usable && !failsOn(command.failOn, result.findings) ? 0 : 3;
}

} // namespace

void addSolve(CLI::App& app, int& exitCode) {
  auto command = std::make_shared<SolveCommand>();
  CLI::App* solver = app.get_subcommand("solve");
  solver->footer("Example: naocal solve captures/ -o result.json --with cameraTranslation@top");
  solver->add_option("SET", command->sets, "folders with captures.json")->type_name("FOLDER")->required();
  solver->add_option("-o,--output", command->output, "write the result to this file")
      ->type_name("FILE")
      ->check(replaceableFile("naocal-result"));
  solver->add_option("--json", command->json, "write the result as JSON to this file, or - for standard output")
      ->type_name("FILE")
      ->check(replaceableFile("naocal-result"));
  solver->add_option("--with", command->with, "effects to add, such as elasticity@LKneePitch; * matches any place")
      ->type_name("EFFECT@PLACE")
      ->delimiter(',');
  solver->add_option("--without", command->without, "effects to leave out, such as jointOffset@HeadYaw")
      ->type_name("EFFECT@PLACE")
      ->delimiter(',');
  solver->add_option("--model", command->model, "a model file: effects to add, to leave out, and effects of your own")
      ->type_name("FILE");
  solver
      ->add_option("--start", command->start,
                   "start the search at another result, or at a file of 'naocal import'; default: the drawing")
      ->type_name("FILE")
      ->group(expertOptions);
  solver->add_option("--restarts", command->options.restarts, "extra searches from random starting points")
      ->group(expertOptions)
      ->check(wholeNumber(0, 1000))
      ->capture_default_str();
  solver->add_option("--seed", command->options.seed, "seed of the random starting points")
      ->group(expertOptions)
      ->capture_default_str();
  solver
      ->add_option("--tolerance", command->options.tolerance,
                   "largest bound (99.95 %) of the error at the task at which the result is usable [m]; default: of a "
                   "ball 2 m ahead 0.05 where a cause is missing, of a robot's tool 10 noise floors, at most 0.005")
      ->type_name("METRES")
      ->check(number(1e-6, 10.0));
  addFailOn(*solver, command->failOn);
  solver->add_flag("--same-place", command->samePlace,
                   "boards and stances with the same id have the same placement in all sets");
  solver->add_flag("--skip-bad", command->skipBad, "use the other captures when some cannot be used, and list those");
  solver->add_flag("--alternate", command->options.alternate, "fit joints and cameras alternately instead of jointly")
      ->group(expertOptions);
  solver->add_flag("--plain", command->plain, "no outlier weighting")->group(expertOptions);
  solver->add_flag("--fixed-noise", command->fixedNoise, "use the noise options as given, do not estimate noise")
      ->group(expertOptions);
  auto* pixel = solver
                    ->add_option("--pixel-noise", command->options.noise.pixel,
                                 "standard deviation of a corner, per axis [px]; a starting value unless --fixed-noise")
                    ->group(expertOptions)
                    ->check(number(0.001, 100.0))
                    ->capture_default_str();
  solver
      ->add_option("--encoder-noise", command->options.noise.encoder, "standard deviation of an encoder reading [rad]")
      ->group(expertOptions)
      ->check(number(1e-7, 0.1));
  solver
      ->add_option("--pose-noise", command->options.noise.pose,
                   "standard deviation of the joint deflection that a pose's captures share [rad]")
      ->group(expertOptions)
      ->check(number(0.0, 0.1))
      ->capture_default_str();
  solver
      ->add_option("--stance-noise", command->options.noise.stance,
                   "standard deviation of the joint deflection that a pose's captures in one stance share [rad]")
      ->group(expertOptions)
      ->check(number(0.0, 0.1))
      ->capture_default_str();
  solver->callback([command, pixel, &exitCode] {
    command->options.pixelGiven = pixel->count() > 0;
    exitCode = solve(*command);
  });
}

} // namespace naocal
