#include "EvaluateThesis.hpp"

#include "Commands.hpp"
#include "Outputs.hpp"
#include "Progress.hpp"
#include "Sets.hpp"
#include "Shard.hpp"
#include "ThesisRun.hpp"
#include "ThesisStory.hpp"

#include "io/InputError.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <thread>

namespace naocal {

namespace {

struct ThesisCommand {
  ThesisEvaluation evaluation;
  std::string shard = "0/1", json;
  double tolerance = toleranceDegrees(statusTolerance);
  unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
  bool resume = false;
};

/// Takes over what an interrupted run of the same evaluation kept.
void resume(ThesisEvaluation& evaluation, const std::string& json) {
  if (json.empty() || json == "-") {
    throw InputError{"--resume: expected --json with the file to go on with, found none"};
  }
  if (!std::filesystem::exists(json)) {
    return;
  }
  ThesisEvaluation kept = readEvaluation(json);
  if (kept.seed != evaluation.seed || kept.sets != evaluation.sets || kept.pixel != evaluation.pixel ||
      kept.parts != evaluation.parts || kept.done != evaluation.done) {
    throw InputError{fmt::format("{}: expected an evaluation with the same --seed, --sets, --pixel and --shard, found "
                                 "another; go on with those, or leave --resume out",
                                 json)};
  }
  evaluation.joints = std::move(kept.joints);
  evaluation.outcomes = std::move(kept.outcomes);
}

void evaluateThesis(ThesisCommand command) {
  const Shard shard = readShard(command.shard);
  command.evaluation.parts = shard.parts;
  command.evaluation.done = {shard.part};
  if (command.resume) {
    resume(command.evaluation, command.json);
  }
  runThesis(command.evaluation, command.jobs, [&command] {
    if (!command.json.empty() && command.json != "-") {
      writeJson(evaluationJson(command.evaluation), command.json);
    }
  });
  if (Progress::interrupted()) {
    fmt::print(stderr, "stopped; what is done is kept{}\n",
               command.json.empty() ? "" : ", with --resume the same command goes on");
  }
  if (command.json == "-") {
    writeJson(evaluationJson(command.evaluation), command.json);
  } else {
    printThesisTables(command.evaluation, command.tolerance);
  }
}

} // namespace

void mergeThesis(const std::vector<std::string>& files, const std::string& json) {
  std::vector<ThesisEvaluation> parts;
  std::transform(files.begin(), files.end(), std::back_inserter(parts), readEvaluation);
  const ThesisEvaluation all = merged(parts);
  if (!json.empty()) {
    writeJson(evaluationJson(all), json);
  }
  if (json != "-") {
    printThesisTables(all, toleranceDegrees(statusTolerance));
  }
}

void addEvaluateThesis(CLI::App& evaluate) {
  auto command = std::make_shared<ThesisCommand>();
  CLI::App* thesis = evaluate.add_subcommand(
      "thesis", "the tables 5.5 to 5.8 of the thesis: how often joint offsets are found, ours beside plain "
                "Levenberg-Marquardt, the Cramer-Rao limit and the thesis's figures");
  thesis->footer("Example: naocal evaluate thesis --sets 1000 --json thesis.json\n"
                 "On a cluster: naocal evaluate thesis --shard $I/$N --json part$I.json, then naocal evaluate merge.");
  thesis->add_option("--sets", command->evaluation.sets, "error sets per cell")
      ->check(CLI::Range(1, 100'000'000))
      ->capture_default_str();
  thesis->add_option("--seed", command->evaluation.seed, "other sets for every seed")->capture_default_str();
  thesis->add_option("--pixel", command->evaluation.pixel, "corner noise where there is any [px]")
      ->check(CLI::Range(0.001, 100.0))
      ->capture_default_str();
  thesis
      ->add_option("--others", command->evaluation.others,
                   "sets of table 5.5 for dlib's find_min_global and a particle swarm too, ten times as many for "
                   "Levenberg-Marquardt with numeric derivatives")
      ->check(CLI::Range(0, 10'000))
      ->capture_default_str();
  thesis->add_option("--tolerance", command->tolerance, "of the tables that are printed [deg]; the JSON has all")
      ->check(CLI::Range(toleranceDegrees(0), toleranceDegrees(toleranceCount - 1)))
      ->capture_default_str();
  thesis->add_option("--shard", command->shard, "i/n: only every n-th set, from the i-th on (counted from 0)");
  thesis->add_option("--jobs", command->jobs, "threads")->check(CLI::PositiveNumber);
  thesis
      ->add_option("--json", command->json,
                   "the evaluation as JSON to a file, kept up to date, or - for standard output")
      ->check(replaces("naocal-evaluation"));
  thesis->add_flag("--resume", command->resume, "go on with what the file of --json holds");
  thesis->callback([command] { evaluateThesis(*command); });
}

} // namespace naocal
