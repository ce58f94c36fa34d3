#include "Commands.hpp"
#include "Sets.hpp"

#include "calibrate/Calibration.hpp"
#include "calibrate/Verdict.hpp"
#include "captures/Files.hpp"
#include "captures/InputError.hpp"
#include "geometry/Angles.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace naocal {

namespace {

struct SolveCommand {
  std::vector<std::string> sets, with, without;
  std::string output, json, model;
  bool samePlace = false, skipBad = false, fixedNoise = false, plain = false;
  CalibrationOptions options;
};

/// Adds a model file's terms to those given on the command line.
void readModel(SolveCommand& command) {
  if (command.model.empty()) {
    return;
  }
  try {
    const auto model = nlohmann::json::parse(fileContent(command.model));
    if (model.value("format", "") != "naocal-model") {
      throw InputError{fmt::format("{}: format: expected \"naocal-model\"", command.model)};
    }
    for (const auto& [key, list] : {std::pair{"with", &command.with}, std::pair{"without", &command.without}}) {
      for (const auto& term : model.value(key, nlohmann::json::array())) {
        list->push_back(term.get<std::string>());
      }
    }
    if (!model.value("define", nlohmann::json::array()).empty()) {
      throw InputError{
          fmt::format("{}: define: effects of your own are not understood by this version", command.model)};
    }
  } catch (const nlohmann::json::exception& error) {
    throw InputError{fmt::format("{}: not a model file: {}", command.model, error.what())};
  }
}

std::string bar(double share) {
  std::string result;
  for (int i = 0; i < static_cast<int>(std::lround(10 * std::clamp(share, 0.0, 1.0))); ++i) {
    result += "█";
  }
  return result;
}

void printEstimates(const Model& model, const CalibrationResult& result) {
  fmt::print("\n  {:<38} {:>12}   {:>10}   learned\n", "unknown", "estimate", "±  1 sigma");
  for (const Term& term : model.terms()) {
    for (std::size_t i = 0; i < term.effect.unknowns.size() && !term.isPlacement; ++i) {
      const Unknown& unknown = term.effect.unknowns[i];
      const Estimate& estimate = result.estimates[term.first + i];
      const bool angle = unknown.unit == "rad", length = unknown.unit == "m";
      const double scale = angle ? degrees(1.0) : length ? 1000 : 1;
      const std::string name =
          term.effect.name == "jointOffset" ? term.place : fmt::format("{} {}", term.label(), unknown.name);
      fmt::print("  {:<38} {:>10.4f} {:<2}  {:>8.4f} {:<2}  {:>3.0f} % {}\n", name, scale * estimate.value,
                 angle                 ? "°"
                 : length              ? "mm"
                 : unknown.unit == "1" ? ""
                                       : unknown.unit,
                 scale * estimate.sigma,
                 angle                 ? "°"
                 : length              ? "mm"
                 : unknown.unit == "1" ? ""
                                       : unknown.unit,
                 100 * estimate.learned, bar(estimate.learned));
    }
  }
}

void printStory(const GivenSets& given, const Measurements& measurements, const Model& model,
                const CalibrationResult& result) {
  fmt::print("{}: {} corners in {} pictures of {} poses, {} unknowns; {} after {} iterations in {:.1f} ms\n",
             measurements.robot.model, measurements.cornerCount, measurements.pictures.size(),
             measurements.poses.size(), model.unknownCount(), result.converged ? "converged" : "NOT converged",
             result.iterations, 1e3 * result.seconds);
  fmt::print(
      "corners lie {:.2f} px rms from their predictions (median {:.2f}); noise: {:.3f} px, encoder {:.4f}°, pose "
      "{:.4f}° ({}); chi2/dof {:.3f}, p {:.2g}\n",
      result.rmsPx, result.medianPx, result.noise.pixel, degrees(result.noise.encoder), degrees(result.noise.pose),
      result.noiseSource, result.chi2 / std::max(1.0, result.dof), result.pValue);
  if (result.floorErrorAt2m > 0) {
    fmt::print("a floor point 2 m ahead will be seen {:.1f} mm off (1 sigma)\n", 1e3 * result.floorErrorAt2m);
  }
  printEstimates(model, result);
  for (const WeakDirection& weak : result.weak) {
    fmt::print("\nweak: {}\n", weak.sentence);
  }
  for (const Doubt& doubt : result.doubts) {
    const Picture& picture = measurements.pictures[doubt.picture];
    fmt::print("\ndoubtful: capture {} ({}), board {}: {} {:.1f} px off{}",
               given.sets[picture.set].captures[picture.capture].id,
               given.sets[picture.set].captures[picture.capture].camera,
               measurements.targets[picture.sightings[doubt.sighting].view.board()].name,
               doubt.whole ? fmt::format("{} corners together", doubt.corners.size())
                           : fmt::format("{} corner{}", doubt.corners.size(), doubt.corners.size() == 1 ? "" : "s"),
               doubt.distance, doubt.whole ? ": was the board moved or the robot touched?" : "");
  }
  for (const std::string& warning : result.warnings) {
    fmt::print("\nwarning: {}", warning);
  }
  if (result.restartsTried > 0) {
    fmt::print("\n{} random restarts {} the answer", result.restartsTried,
               result.restartsChanged ? "CHANGED" : "did not change");
  }
  fmt::print("\n{}\n", result.usable ? "The result can be used." : "The result should NOT be used.");
}

int solve(SolveCommand& command) {
  readModel(command);
  command.options.estimateNoise = !command.fixedNoise;
  command.options.robust = !command.plain;
  const GivenSets given = readSets(command.sets, command.skipBad);
  const Measurements measurements = measurementsOf(given.sets, given.robot, command.samePlace);
  const Model model = makeModel(measurements, command.with, command.without);
  const CalibrationResult result = calibrate(measurements, model, command.options);
  const auto json = resultJson(given.sets, measurements, model, result, given.inputs);
  if (!command.output.empty()) {
    writeJson(json, command.output);
  }
  if (!command.json.empty()) {
    writeJson(json, command.json);
  }
  if (command.json != "-") {
    printStory(given, measurements, model, result);
    if (!command.output.empty()) {
      fmt::print("written to {}\n", command.output);
    }
  }
  return result.usable ? 0 : 3;
}

} // namespace

void addSolve(CLI::App& app, int& exitCode) {
  auto command = std::make_shared<SolveCommand>();
  CLI::App* solver = app.add_subcommand("solve", "calibrates joints and cameras from capture sets");
  solver->footer("Example: naocal solve captures/ -o result.json --with cameraTranslation@top");
  solver->add_option("SET", command->sets, "folders with captures.json")->required();
  solver->add_option("-o,--output", command->output, "the result file to write");
  solver->add_option("--json", command->json, "the same as JSON to a file, or - for standard output");
  solver->add_option("--with", command->with, "add effects: EFFECT@PLACE, * allowed")->delimiter(',');
  solver->add_option("--without", command->without, "leave effects out")->delimiter(',');
  solver->add_option("--model", command->model, "a model file: {\"format\": \"naocal-model\", \"with\": [...], ...}");
  solver->add_option("--restarts", command->options.restarts, "random starts beside the ordinary one");
  solver->add_option("--seed", command->options.seed, "of the random starts");
  solver->add_flag("--same-place", command->samePlace,
                   "boards and stances of equal names lie at the same place in all sets");
  solver->add_flag("--skip-bad", command->skipBad, "use the other captures when some cannot be used, and list those");
  solver->add_flag("--alternate", command->options.alternate, "joints and cameras in turns instead of together");
  solver->add_flag("--plain", command->plain, "every corner counts fully, however far off");
  solver->add_flag("--fixed-noise", command->fixedNoise, "take noise levels as given instead of estimating them");
  auto* pixel = solver->add_option("--pixel-noise", command->options.noise.pixel, "of a corner, per axis [px]");
  solver->add_option("--encoder-noise", command->options.noise.encoder, "of a reading [rad]");
  solver->add_option("--pose-noise", command->options.noise.pose, "deflection shared by a pose's captures [rad]");
  solver->callback([command, pixel, &exitCode] {
    command->options.pixelGiven = pixel->count() > 0;
    exitCode = solve(*command);
  });
}

} // namespace naocal
