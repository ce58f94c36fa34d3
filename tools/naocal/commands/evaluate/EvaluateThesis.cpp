#include "commands/evaluate/EvaluateThesis.hpp"

#include "command-line/OptionChecks.hpp"
#include "commands/Commands.hpp"
#include "commands/evaluate/ThesisFileOptions.hpp"
#include "console/CommandLine.hpp"
#include "console/OutputFiles.hpp"
#include "console/Progress.hpp"
#include "console/print/PrintText.hpp"
#include "console/print/PrintThesis.hpp"
#include "evaluation/thesis/ThesisExperiment.hpp"
#include "evaluation/thesis/ThesisFiles.hpp"
#include "evaluation/thesis/ThesisPoses.hpp"
#include "evaluation/thesis/ThesisTables.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"

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

using Tallies = std::map<ThesisSolver, ThesisTally>;

/// What to run, beside the evaluation's sets and seed.
struct ThesisPlan {
  SolvedSettings settings;
  ThesisInputs inputs;
  std::vector<Eigen::VectorXd> poses; // of a file [rad]; empty: those of the settings
  bool keepsRows = false;
};

/// Results of the error sets of one setting, per solver; rows only if the plan keeps them.
struct SettingResult {
  Tallies tallies;
  std::vector<ThesisRow> rows;

  void add(SettingResult other) {
    for (const auto& [solver, tally] : other.tallies) {
      tallies[solver].add(tally);
    }
    rows.insert(rows.end(), std::make_move_iterator(other.rows.begin()), std::make_move_iterator(other.rows.end()));
  }
};

/// Evaluates the error sets of one setting on several threads.
class SettingRun {
public:
  SettingRun(const ThesisExperiment& stage, const std::pair<ThesisSetting, std::vector<ThesisSolver>>& solved,
             const ThesisEvaluation& evaluation, bool keepsRows)
      : stage_{stage}, setting_{solved.first}, solvers_{solved.second}, evaluation_{evaluation}, keepsRows_{keepsRows} {
  }

  /// Calls `told(count)` for finished sets; stops if it returns false. Absent if stopped.
  template <typename Told> std::optional<SettingResult> run(unsigned jobs, Told told) {
    std::vector<std::thread> workers;
    for (unsigned job = 0; job < jobs; ++job) {
      workers.emplace_back([&] {
        SettingResult own = work(told);
        const std::lock_guard lock{adding_};
        sum_.add(std::move(own));
      });
    }
    for (std::thread& worker : workers) {
      worker.join();
    }
    return stopped_ ? std::nullopt : std::optional{sum_};
  }

private:
  template <typename Told> SettingResult work(Told told) {
    constexpr std::size_t atOnce = 50;
    ThesisTrial trial{stage_, setting_, evaluation_.pixel};
    SettingResult own;
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

  void addSet(ThesisTrial& trial, std::size_t set, SettingResult& own) const {
    constexpr std::size_t draws = 10;
    trial.draw(evaluation_.seed, set);
    const std::vector<double> limit = trial.drawLimitErrors(draws);
    for (const ThesisSolver solver : solvers_) {
      if (set >= evaluation_.setsOf(solver)) {
        continue;
      }
      const auto start = std::chrono::steady_clock::now();
      const ThesisSolution answer = trial.solve(solver);
      ThesisTally& tally = own.tallies[solver];
      tally.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      tally.add(trial.offsets(), answer, limit);
      if (setting_.likeProgram() && answer.solved) {
        examine(trial, solver, answer, tally);
      }
      if (keepsRows_) {
        own.rows.push_back({setting_, set, solver, answer, trial.offsets()});
      }
    }
  }

  /// Maps residuals on the floor, and restarts noiseless failures of the thesis's program with exact derivatives.
  void examine(const ThesisTrial& trial, ThesisSolver solver, const ThesisSolution& answer, ThesisTally& tally) const {
    if (solver != ThesisSolver::plain) {
      trial.addResiduals(answer, tally.residuals);
    }
    const bool isProgram = solver == ThesisSolver::program || solver == ThesisSolver::programStarts;
    if (isProgram && setting_.noise == ThesisNoise::none &&
        answer.status(radians(toleranceDegrees(statusTolerance))) != ThesisStatus::success) {
      ++tally.restarts;
      tally.reached += trial.reachesTruthFrom(answer);
      tally.ranOut += answer.ranOut;
    }
  }

  const ThesisExperiment& stage_;
  const ThesisSetting& setting_;
  const std::vector<ThesisSolver>& solvers_;
  const ThesisEvaluation& evaluation_;
  const bool keepsRows_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex adding_;
  SettingResult sum_;
};

/// The settings of the tables, or only of those as the thesis's program made them.
SolvedSettings settingsOfTables(const ThesisEvaluation& evaluation, bool onlyProgram) {
  SolvedSettings settings;
  for (auto& [setting, solvers] : thesisSettings()) {
    if (onlyProgram && !setting.likeProgram()) {
      continue;
    }
    settings.emplace_back(setting, solvers);
    for (const ThesisSolver solver : {ThesisSolver::numeric, ThesisSolver::dlib, ThesisSolver::swarm}) {
      if (isInTable55(setting) && evaluation.setsOf(solver) > 0) {
        settings.back().second.push_back(solver);
      }
    }
  }
  return settings;
}

/// Runs all settings of the plan that the evaluation lacks, for the sets of its part, on several threads; calls `keep`
/// after each setting. Shows progress; Ctrl-C stops it and discards the unfinished setting. Returns the rows.
std::vector<ThesisRow> runThesis(const ThesisPlan& plan, ThesisEvaluation& evaluation, unsigned jobs,
                                 const std::function<void()>& keep) {
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  std::map<std::pair<ThesisFeature, PoseChoice>, std::vector<Eigen::VectorXd>> chosen;
  const Progress progress{"error sets"};
  std::mutex telling;
  std::size_t done = 0;
  std::vector<ThesisRow> rows;
  const auto told = [&](std::size_t sets) {
    const std::lock_guard lock{telling};
    return progress(done += sets, plan.settings.size() * evaluation.sets);
  };
  for (const auto& solved : plan.settings) {
    const ThesisSetting& setting = solved.first;
    if (std::all_of(solved.second.begin(), solved.second.end(),
                    [&](ThesisSolver solver) { return evaluation.tally(setting, solver); })) {
      told(evaluation.sets);
      continue;
    }
    std::vector<Eigen::VectorXd>& nested = chosen[{setting.feature, setting.choice}];
    if (nested.empty()) {
      nested = plan.poses.empty() ? selectThesisPoses(robot, setting.feature, setting.choice, 8) : plan.poses;
    }
    const ThesisExperiment stage{robot, setting, posesForSetting(setting, robot, nested), plan.inputs};
    if (const auto names = stage.jointNames(); names.size() > evaluation.joints.size()) {
      evaluation.joints = names; // joints of one leg come first
    }
    auto result = SettingRun{stage, solved, evaluation, plan.keepsRows && !setting.bothLegs}.run(jobs, told);
    if (!result) {
      break;
    }
    for (const auto& [solver, tally] : result->tallies) {
      evaluation.outcomes.push_back(
          {setting, solver, tally,
           setting.likeProgram() ? stage.fieldsOfView() : std::vector<std::array<Eigen::Vector2d, 4>>{}});
    }
    std::move(result->rows.begin(), result->rows.end(), std::back_inserter(rows));
    keep();
  }
  return rows;
}

struct ThesisCommand {
  ThesisEvaluation evaluation;
  ThesisFileOptions files;
  std::string shard = "0/1", json, rows;
  double tolerance = toleranceDegrees(statusTolerance);
  unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
  bool resume = false, onlyProgram = false;
};

/// What to run; for a run with files also adapts the number of sets to the file's.
ThesisPlan planRun(ThesisCommand& command) {
  ThesisPlan plan{.keepsRows = !command.rows.empty()};
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  if (!command.files.isUsed()) {
    plan.settings = settingsOfTables(command.evaluation, command.onlyProgram);
    plan.inputs.heldOut = selectHeldOutPoses(robot, programJoints(), programTestPoses);
    return plan;
  }
  ThesisFileRun files = prepareFileRun(command.files, robot, command.evaluation.sets, command.evaluation.seed);
  command.evaluation.sets = std::min(command.evaluation.sets, files.inputs.offsets.size());
  command.evaluation.inputs = files.hashes;
  for (const ThesisSetting& setting : fileSettings(files.setting)) {
    plan.settings.emplace_back(setting, std::vector{ThesisSolver::plain, ThesisSolver::ours, ThesisSolver::program});
  }
  plan.inputs = std::move(files.inputs);
  plan.poses = std::move(files.poses);
  return plan;
}

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
      kept.parts != evaluation.parts || kept.done != evaluation.done || kept.inputs != evaluation.inputs) {
    throw InputError{fmt::format("{}: expected an evaluation with the same --seed, --sets, --pixel, --shard and input "
                                 "files, found another; go on with those, or leave --resume out",
                                 json)};
  }
  evaluation.joints = std::move(kept.joints);
  evaluation.outcomes = std::move(kept.outcomes);
}

void evaluateThesis(ThesisCommand command) {
  const Shard shard = parseShard(command.shard);
  command.evaluation.parts = shard.parts;
  command.evaluation.done = {shard.part};
  const ThesisPlan plan = planRun(command);
  if (command.resume) {
    resume(command.evaluation, command.json);
  }
  const std::vector<ThesisRow> rows = runThesis(plan, command.evaluation, command.jobs, [&command] {
    if (!command.json.empty() && command.json != "-") {
      writeJson(evaluationJson(command.evaluation), command.json);
    }
  });
  if (!command.rows.empty()) {
    writeTable(command.rows, formatRows(rows, programJoints(), radians(command.tolerance)));
  }
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
  thesis
      ->add_option("--rows", command->rows,
                   "one row per error set and solver (CSV): status, errors, residual and injected offsets; only of "
                   "what this run evaluates with 8 offsets")
      ->type_name("FILE")
      ->group(expertOptions)
      ->check(replaceableTable(rowsKind));
  thesis->add_flag("--program", command->onlyProgram, "only the tables as the thesis's own program made them");
  command->files.add(*thesis);
  thesis->add_flag("--resume", command->resume, "go on with what the file of --json holds")->group(expertOptions);
  thesis->callback([command] { evaluateThesis(*command); });
}

} // namespace naocal
