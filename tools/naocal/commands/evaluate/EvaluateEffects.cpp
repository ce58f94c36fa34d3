#include "commands/Commands.hpp"
#include "commands/evaluate/EvaluateThesis.hpp"
#include "console/CommandLine.hpp"
#include "console/Progress.hpp"
#include "console/Subprocess.hpp"
#include "console/print/PrintText.hpp"

#include "command-line/OptionChecks.hpp"
#include "estimation/ModelFile.hpp"
#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/Programs.hpp"
#include "robot/Robot.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fmt/core.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace naocal {

namespace {

/// Size and contents of the blind benchmark.
struct BlindPlan {
  std::filesystem::path out;
  std::uint64_t seed = 1;
  int controls = 4;        // per noise regime
  int sets = 1;            // per effect and size; otherwise per case
  double pictureShare = 0; // fraction of controls and catalogued effects that is rendered instead of given as corners
  std::string only;        // a single group; empty: all
  bool keep = false;       // keeps the sets after answering
  bool robots = false;     // robots with a URDF instead of NAOs
};

/// Runs naocal on robots with unknown flaws. Uses only programs and files, as a user would: blind-writer, naocal
/// detect, diagnose, solve and compare. Thread-safe.
class BlindRun {
public:
  /// Finds the programs beside this one. Throws InputError if they are missing.
  explicit BlindRun(BlindPlan plan);

  /// Number of sets in the plan.
  std::size_t size() const { return size_; }
  bool isAnswered(std::size_t number) const;
  /// Writes and answers one set; the answer file is written atomically. False if a program was interrupted.
  bool runSet(std::size_t number) const;

private:
  std::vector<std::string> writerCommand() const;
  std::filesystem::path answerFile(std::size_t number) const;

  BlindPlan plan_;
  std::filesystem::path naocal_, writer_;
  std::size_t size_ = 0;
};

namespace files = std::filesystem;

nlohmann::json jsonOf(const files::path& file) {
  return nlohmann::json::parse(readFile(file));
}

std::string setName(std::size_t number) {
  return fmt::format("s{:06}", number);
}

/// Processes one set through the programs; a temporary folder holds intermediate files.
class Question {
public:
  Question(files::path naocal, files::path out, std::string name)
      : naocal_{std::move(naocal)}, set_{out / "sets" / name}, locked_{out / "locked" / name}, between_{out /
                                                                                                        "between" /
                                                                                                        name} {
    files::create_directories(between_);
  }
  ~Question() { files::remove_all(between_); }
  Question(const Question&) = delete;
  Question& operator=(const Question&) = delete;

  /// naocal's answer; absent if interrupted: a command that Ctrl-C has reached, too, may have answered for a part.
  std::optional<nlohmann::json> answer(bool pictures) const {
    try {
      nlohmann::json whole = askAll(pictures);
      return Progress::wasInterrupted() ? std::nullopt : std::optional{std::move(whole)};
    } catch (const Stopped&) {
      return std::nullopt;
    }
  }

private:
  struct Stopped {};

  /// Runs a command of naocal. Throws Stopped if it was killed.
  static ProcessResult ask(const std::vector<std::string>& command) {
    ProcessResult finished = runProcess(command);
    if (finished.stopped) {
      throw Stopped{};
    }
    return finished;
  }

  nlohmann::json askAll(bool pictures) const {
    if (pictures) {
      const ProcessResult found = ask({naocal_, "detect", set_.string(), "--threads", "1"});
      if (found.exitCode != 0) {
        return refused(found);
      }
    }
    const auto start = std::chrono::steady_clock::now();
    const ProcessResult said =
        ask({naocal_, "diagnose", set_.string(), "--json", between_ / "diagnosis.json", "--next-count", "0"});
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    if (said.exitCode != 0 && said.exitCode != 3) {
      return refused(said);
    }
    nlohmann::json answer{
        {"exitCode", said.exitCode}, {"seconds", seconds.count()}, {"locked", nlohmann::json::object()}};
    answer["diagnosis"] = jsonOf(between_ / "diagnosis.json");
    const auto suggested = answer["diagnosis"].value("suggested", std::vector<std::string>{});
    answer["solved"] = solved({}, "before.json");
    if (files::exists(locked_)) { // robots with a URDF have neither, and no figures of them
      answer["solvedWithFixedNoise"] = solved({"--fixed-noise"}, "fixed.json");
    }
    if (!suggested.empty()) {
      answer["solvedWithSuggested"] = solved(adding(suggested, answer["diagnosis"]), "after.json");
      answer["locked"] = locked();
    }
    return answer;
  }

  static nlohmann::json refused(const ProcessResult& finished) {
    return {{"exitCode", finished.exitCode},
            {"error", finished.said},
            {"diagnosis", nullptr},
            {"locked", nlohmann::json::object()}};
  }

  /// Errors on the locked poses, which were never used for selection, with and without the suggested effects. Empty if
  /// they cannot be computed.
  nlohmann::json locked() const {
    if (!files::exists(locked_) || !files::exists(between_ / "before.json") ||
        !files::exists(between_ / "after.json") ||
        ask({naocal_, "compare", between_ / "after.json", locked_, "--against", between_ / "before.json", "--json",
             between_ / "compared.json"})
                .exitCode != 0) {
      return nlohmann::json::object();
    }
    const nlohmann::json compared = jsonOf(between_ / "compared.json");
    const nlohmann::json& before = compared.at("against");
    return {{"beforePx", before.at("rmsPx")},
            {"afterPx", compared.at("rmsPx")},
            {"weightedBeforePx", before.at("weightedPx")},
            {"weightedAfterPx", compared.at("weightedPx")}};
  }

  /// Options of solve that add the suggested effects: a model file if the diagnosis defines custom effects.
  std::vector<std::string> adding(const std::vector<std::string>& suggested, const nlohmann::json& diagnosis) const {
    const nlohmann::json define = diagnosis.value("define", nlohmann::json::array());
    if (define.empty()) {
      return {"--with", fmt::format("{}", fmt::join(suggested, ","))};
    }
    writeAtomically(between_ / "model.json", modelFileJson(suggested, {}, define).dump());
    return {"--model", between_ / "model.json"};
  }

  /// The calibration's summary from RESULT.json; null if there is none.
  nlohmann::json solved(const std::vector<std::string>& options, const char* file) const {
    std::vector<std::string> solve{naocal_, "solve", set_.string(), "-o", between_ / file};
    solve.insert(solve.end(), options.begin(), options.end());
    const int exitCode = ask(solve).exitCode;
    if ((exitCode != 0 && exitCode != 3) || !files::exists(between_ / file)) {
      return nullptr;
    }
    const nlohmann::json result = jsonOf(between_ / file);
    nlohmann::json told{{"exitCode", exitCode}};
    for (const char* key : {"usable", "verdict", "pValue", "rmsPx", "noise", "effects", "converged"}) {
      if (result.contains(key)) {
        told[key] = result.at(key);
      }
    }
    return told;
  }

  std::string naocal_;
  files::path set_, locked_, between_;
};

BlindRun::BlindRun(BlindPlan plan)
    : plan_{std::move(plan)}, naocal_{requireProgram("naocal")}, writer_{requireProgram("blind-writer")} {
  std::vector<std::string> command = writerCommand();
  command.emplace_back("--size");
  const ProcessResult counted = runProcess(command);
  if (counted.exitCode != 0) {
    throw InputError{counted.said};
  }
  size_ = std::stoul(counted.printed);
}

std::vector<std::string> BlindRun::writerCommand() const {
  std::vector<std::string> command{writer_,      plan_.out,
                                   "--seed",     fmt::format("{}", plan_.seed),
                                   "--controls", fmt::format("{}", plan_.controls),
                                   "--sets",     fmt::format("{}", plan_.sets),
                                   "--pictures", fmt::format("{}", plan_.pictureShare),
                                   "--drawing",  configurationDirectory() / "drawings" / "NaoV6.json"};
  if (!plan_.only.empty()) {
    command.insert(command.end(), {"--only", plan_.only});
  }
  if (plan_.robots) {
    command.emplace_back("--robot");
  }
  return command;
}

files::path BlindRun::answerFile(std::size_t number) const {
  return plan_.out / "answers" / (setName(number) + ".json");
}

bool BlindRun::isAnswered(std::size_t number) const {
  return files::exists(answerFile(number));
}

bool BlindRun::runSet(std::size_t number) const {
  const std::string name = setName(number);
  std::vector<std::string> write = writerCommand();
  write.insert(write.end(), {"--first", fmt::format("{}", number), "--count", "1"});
  const ProcessResult written = runProcess(write);
  if (written.stopped) {
    return false;
  }
  if (written.exitCode != 0) {
    throw InputError{written.said};
  }
  const nlohmann::json manifest = jsonOf(plan_.out / "manifest" / (name + ".json"));
  auto answer = Question{naocal_, plan_.out, name}.answer(manifest.at("pictures").get<bool>());
  if (!answer) {
    return false;
  }
  answer->update(withFormat("naocal-blind-answer", {{"set", name}, {"truthSha256", manifest.at("truthSha256")}}));
  files::create_directories(plan_.out / "answers");
  writeAtomically(answerFile(number), answer->dump(1) + "\n");
  if (!plan_.keep) {
    files::remove_all(plan_.out / "sets" / name);
    files::remove_all(plan_.out / "locked" / name);
  }
  return true;
}

/// Runs blind-judge on a folder and prints its output. `json`, `page`: files to write; empty: none.
void runJudge(const files::path& folder, const std::string& json, const std::string& page) {
  std::vector<std::string> command{requireProgram("blind-judge"), folder};
  if (!json.empty()) {
    command.insert(command.end(), {"--json", json});
  }
  if (!page.empty()) {
    command.insert(command.end(), {"--page", page});
  }
  const ProcessResult judged = runProcess(command);
  if (judged.exitCode != 0) {
    throw InputError{judged.said};
  }
  printText("{}", judged.printed);
}

struct EvaluateCommand {
  BlindPlan plan;
  std::string out, shard = "0/1", json, page;
  unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
  bool full = false;
  std::vector<std::string> shards;
};

/// Answers all sets without an answer, `jobs` at a time.
void askAll(const BlindRun& run, const std::vector<std::size_t>& numbers, unsigned jobs) {
  const Progress progress{"sets answered"};
  std::atomic<std::size_t> next = 0, done = 0;
  std::atomic<bool> stopped = false;
  std::mutex telling;
  std::string problem;
  const auto work = [&] {
    for (std::size_t i = next++; i < numbers.size() && !stopped; i = next++) {
      try {
        if (!run.isAnswered(numbers[i]) && !run.runSet(numbers[i])) {
          stopped = true;
        }
      } catch (const std::exception& error) {
        const std::lock_guard lock{telling};
        problem = error.what();
        stopped = true;
      }
      const std::lock_guard lock{telling};
      if (!progress(++done, numbers.size())) {
        stopped = true;
      }
    }
  };
  std::vector<std::thread> workers;
  for (unsigned job = 0; job < jobs; ++job) {
    workers.emplace_back(work);
  }
  for (std::thread& worker : workers) {
    worker.join();
  }
  if (!problem.empty()) {
    throw InputError{problem};
  }
}

const std::vector<std::string> naoGroups{"control",   "decoy", "catalogue", "pair", "outside", "absorbed",
                                         "corrupted", "sized", "camera",    "twin", "event",   "jitter"};
const std::vector<std::string> robotGroups{"control", "catalogue", "setup", "event", "reading"};

std::vector<std::string> allGroups() {
  std::vector<std::string> groups = naoGroups;
  groups.insert(groups.end(), {"setup", "reading"});
  return groups;
}

/// Throws InputError for a group that the benchmark does not have, and for pictures of robots with a URDF.
void checkGroup(const BlindPlan& plan) {
  const std::vector<std::string>& groups = plan.robots ? robotGroups : naoGroups;
  if (!plan.only.empty() && std::find(groups.begin(), groups.end(), plan.only) == groups.end()) {
    throw InputError{fmt::format("--only: expected {}{}, found {}", fmt::join(groups, ", "),
                                 plan.robots ? " (with --robot)" : "", plan.only)};
  }
  if (plan.robots && plan.pictureShare > 0) {
    throw InputError{"--pictures: expected no pictures with --robot, whose sets have corners; leave it out"};
  }
}

void evaluateEffects(EvaluateCommand command) {
  if (command.full) { // sizes of the published table
    command.plan.controls = 1000;
    command.plan.sets = 40;
    command.plan.pictureShare = command.plan.robots ? 0 : 0.2;
  }
  checkGroup(command.plan);
  command.plan.out = command.out;
  const BlindRun run{command.plan};
  const auto [part, parts] = parseShard(command.shard);
  std::vector<std::size_t> numbers;
  for (std::size_t number = part; number < run.size(); number += parts) {
    numbers.push_back(number);
  }
  askAll(run, numbers, command.jobs);
  if (Progress::wasInterrupted()) {
    printText("stopped; the answers so far are kept, the same command goes on\n");
  }
  runJudge(command.out, command.json, command.page);
}

/// Merges manifests, truths and answers of all shards into one folder and judges them; if the shards are files, merges
/// thesis evaluations.
void mergeShards(const EvaluateCommand& command) {
  namespace files = std::filesystem;
  if (files::is_regular_file(command.shards.front())) {
    mergeThesis(command.shards, command.json);
    return;
  }
  if (command.out.empty()) {
    throw InputError{"--out: expected the folder that gets all shards of 'naocal evaluate effects', found none"};
  }
  for (const std::string& shard : command.shards) {
    for (const char* folder : {"manifest", "truth", "answers"}) {
      if (!files::is_directory(files::path{shard} / folder)) {
        throw InputError{fmt::format("{}: expected a folder that 'naocal evaluate effects' wrote, found no {} in it",
                                     shard, folder)};
      }
      files::create_directories(files::path{command.out} / folder);
      files::copy(files::path{shard} / folder, files::path{command.out} / folder,
                  files::copy_options::recursive | files::copy_options::overwrite_existing);
    }
  }
  runJudge(command.out, command.json, command.page);
}

void addReports(CLI::App& app, EvaluateCommand& command) {
  app.add_option("--json", command.json, "the evaluation as JSON to a file, or - for standard output")
      ->type_name("FILE");
  app.add_option("--page", command.page, "a page with plots")->type_name("FILE");
}

} // namespace

void addEvaluate(CLI::App& app) {
  CLI::App* evaluate = app.get_subcommand("evaluate");
  evaluate->require_subcommand(1);

  auto asked = std::make_shared<EvaluateCommand>();
  CLI::App* effects =
      evaluate->add_subcommand("effects", "a blind benchmark of the diagnosis: hidden effects, sealed truths");
  effects->footer("Example: naocal evaluate effects --out /tmp/blind --page /tmp/blind.html\n"
                  "         naocal evaluate effects --robot --out /tmp/robots --controls 20\n"
                  "Stopped with Ctrl-C or killed, the same command goes on where it was.");
  effects->add_option("--out", asked->out, "the folder for sets, seals and answers")->type_name("FOLDER")->required();
  effects->add_option("--seed", asked->plan.seed, "another benchmark for every seed")->capture_default_str();
  effects
      ->add_option("--controls", asked->plan.controls, "robots without effect, per noise regime or kind of measurement")
      ->check(wholeNumber(0, 1'000'000))
      ->capture_default_str();
  effects->add_option("--sets", asked->plan.sets, "robots per effect and size, and per case otherwise")
      ->check(wholeNumber(0, 1'000'000))
      ->capture_default_str();
  effects->add_option("--pictures", asked->plan.pictureShare, "share that is rendered")
      ->capture_default_str()
      ->check(number(0.0, 0.9));
  effects->add_option("--only", asked->plan.only, "one group of sets")->type_name("GROUP")->check(oneOf(allGroups()));
  effects->add_flag("--robot", asked->plan.robots,
                    "robots with a URDF, measured by cameras, trackers and contacts, instead of NAOs");
  effects->add_option("--shard", asked->shard, "i/n: only every n-th set, from the i-th on (counted from 0)")
      ->type_name("I/N")
      ->group(expertOptions);
  effects->add_option("--jobs", asked->jobs, "sets at a time")->group(expertOptions)->check(wholeNumber(1, 1024));
  effects->add_flag("--full", asked->full,
                    "the full table: 1000 controls per regime, 40 sets per cell, a fifth rendered");
  effects->add_flag("--keep", asked->plan.keep, "keep the sets after their answers")->group(expertOptions);
  addReports(*effects, *asked);
  effects->callback([asked] { evaluateEffects(*asked); });

  auto merged = std::make_shared<EvaluateCommand>();
  CLI::App* merge = evaluate->add_subcommand("merge", "judges the shards of an evaluation together");
  merge->footer("Example: naocal evaluate merge --out /tmp/all shard0 shard1 --json evaluation.json\n"
                "         naocal evaluate merge part0.json part1.json --json evaluation.json");
  merge
      ->add_option("SHARDS", merged->shards,
                   "folders of 'naocal evaluate effects', or files of 'naocal evaluate thesis'")
      ->type_name("FILE")
      ->required();
  merge->add_option("--out", merged->out, "the folder that gets all of them, where they are folders")
      ->type_name("FOLDER");
  addReports(*merge, *merged);
  merge->callback([merged] { mergeShards(*merged); });
  addEvaluateNext(*evaluate);
  addEvaluateThesis(*evaluate);
}

} // namespace naocal
