#include "commands/EvaluateThesis.hpp"

#include "command-line/OptionChecks.hpp"
#include "commands/Commands.hpp"
#include "console/CommandLine.hpp"
#include "console/OutputFiles.hpp"
#include "console/PrintText.hpp"
#include "console/PrintThesis.hpp"
#include "console/Progress.hpp"
#include "evaluation/ThesisExperiment.hpp"
#include "evaluation/ThesisTables.hpp"
#include "io/InputError.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <fmt/core.h>
#include <functional>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

namespace naocal {

namespace {

/// One worker's results, per solver.
using Tallies = std::map<ThesisSolver, ThesisTally>;

/// Evaluates the error sets of one setting on several threads.
class SettingRun {
public:
  SettingRun(const ThesisExperiment& stage, const ThesisSetting& setting, const std::vector<ThesisSolver>& solvers,
             const ThesisEvaluation& evaluation)
      : stage_{stage}, setting_{setting}, solvers_{solvers}, evaluation_{evaluation} {}

  /// Calls `told(count)` for finished sets; stops if it returns false. Absent if stopped.
  template <typename Told> std::optional<Tallies> tallies(unsigned jobs, Told told) {
    std::vector<std::thread> workers;
    for (unsigned job = 0; job < jobs; ++job) {
      workers.emplace_back([&] {
        const Tallies own = work(told);
        const std::lock_guard lock{adding_};
        for (const auto& [solver, tally] : own) {
          sum_[solver].add(tally);
        }
      });
    }
    for (std::thread& worker : workers) {
      worker.join();
    }
    return stopped_ ? std::nullopt : std::optional{sum_};
  }

private:
  template <typename Told> Tallies work(Told told) {
    constexpr std::size_t atOnce = 50;
    ThesisTrial trial{stage_, setting_, evaluation_.pixel};
    Tallies own;
    for (std::size_t first = next_.fetch_add(atOnce); first < evaluation_.sets && !stopped_;
         first = next_.fetch_add(atOnce)) {
      const std::size_t end = std::min(first + atOnce, evaluation_.sets);
      for (std::size_t set = first; set < end; ++set) {
        if (set % evaluation_.parts == evaluation_.done.front()) {
          addSet(trial, set, own);
        }
      }
      if (!told(end - first)) {
        stopped_ = true;
      }
    }
    return own;
  }

  void addSet(ThesisTrial& trial, std::size_t set, Tallies& own) const {
    constexpr std::size_t draws = 10;
    trial.draw(evaluation_.seed, set);
    const std::vector<double> limit = trial.drawLimitErrors(draws);
    for (const ThesisSolver solver : solvers_) {
      if (set >= evaluation_.setsOf(solver)) {
        continue;
      }
      const auto start = std::chrono::steady_clock::now();
      const ThesisSolution answer = trial.solve(solver);
      own[solver].seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      own[solver].add(trial.offsets(), answer, limit);
    }
  }

  const ThesisExperiment& stage_;
  const ThesisSetting& setting_;
  const std::vector<ThesisSolver>& solvers_;
  const ThesisEvaluation& evaluation_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex adding_;
  Tallies sum_;
};

/// Runs all settings that the evaluation lacks, for the sets of its part, on several threads; calls `keep` after each
/// setting. Shows progress; Ctrl-C stops it and discards the unfinished setting.
void runThesis(ThesisEvaluation& evaluation, unsigned jobs, const std::function<void()>& keep) {
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  auto settings = thesisSettings();
  for (auto& [setting, solvers] : settings) {
    for (const ThesisSolver solver : {ThesisSolver::numeric, ThesisSolver::dlib, ThesisSolver::swarm}) {
      if (isInTable55(setting) && evaluation.setsOf(solver) > 0) {
        solvers.push_back(solver);
      }
    }
  }
  std::map<std::pair<ThesisFeature, PoseChoice>, std::vector<Eigen::VectorXd>> chosen;
  const Progress progress{"error sets"};
  std::mutex telling;
  std::size_t done = 0;
  const auto told = [&](std::size_t sets) {
    const std::lock_guard lock{telling};
    return progress(done += sets, settings.size() * evaluation.sets);
  };
  for (const auto& [setting, solvers] : settings) {
    if (std::all_of(solvers.begin(), solvers.end(),
                    [&, &setting = setting](ThesisSolver solver) { return evaluation.tally(setting, solver); })) {
      told(evaluation.sets);
      continue;
    }
    std::vector<Eigen::VectorXd>& nested = chosen[{setting.feature, setting.choice}];
    if (nested.empty()) {
      nested = selectThesisPoses(robot, setting.feature, setting.choice, 8);
    }
    const ThesisExperiment stage{robot, setting, posesForSetting(setting, robot, nested)};
    if (const auto names = stage.jointNames(); names.size() > evaluation.joints.size()) {
      evaluation.joints = names; // joints of one leg come first
    }
    const auto tallies = SettingRun{stage, setting, solvers, evaluation}.tallies(jobs, told);
    if (!tallies) {
      return;
    }
    for (const auto& [solver, tally] : *tallies) {
      evaluation.outcomes.push_back({setting, solver, tally});
    }
    keep();
  }
}

struct ThesisCommand {
  ThesisEvaluation evaluation;
  std::string shard = "0/1", json;
  double tolerance = toleranceDegrees(statusTolerance);
  unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
  bool resume = false;
};

/// Loads the results of an interrupted run of the same evaluation.
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
  const Shard shard = parseShard(command.shard);
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
  if (Progress::wasInterrupted()) {
    printText(stderr, "stopped; what is done is kept{}\n",
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
  const ThesisEvaluation all = mergeEvaluations(parts);
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
      ->check(wholeNumber(1, 100'000'000))
      ->capture_default_str();
  thesis->add_option("--seed", command->evaluation.seed, "other sets for every seed")->capture_default_str();
  thesis->add_option("--pixel", command->evaluation.pixel, "corner noise where there is any [px]")
      ->group(expertOptions)
      ->check(number(0.001, 100.0))
      ->capture_default_str();
  thesis
      ->add_option("--others", command->evaluation.others,
                   "sets of table 5.5 for dlib's find_min_global and a particle swarm too, ten times as many for "
                   "Levenberg-Marquardt with numeric derivatives")
      ->group(expertOptions)
      ->check(wholeNumber(0, 10'000))
      ->capture_default_str();
  thesis->add_option("--tolerance", command->tolerance, "of the tables that are printed [deg]; the JSON has all")
      ->check(number(toleranceDegrees(0), toleranceDegrees(toleranceCount - 1)))
      ->capture_default_str();
  thesis->add_option("--shard", command->shard, "i/n: only every n-th set, from the i-th on (counted from 0)")
      ->type_name("I/N")
      ->group(expertOptions);
  thesis->add_option("--jobs", command->jobs, "threads")->group(expertOptions)->check(wholeNumber(1, 1024));
  thesis
      ->add_option("--json", command->json,
                   "the evaluation as JSON to a file, kept up to date, or - for standard output")
      ->type_name("FILE")
      ->check(replaceableFile("naocal-evaluation"));
  thesis->add_flag("--resume", command->resume, "go on with what the file of --json holds")->group(expertOptions);
  thesis->callback([command] { evaluateThesis(*command); });
}

} // namespace naocal
