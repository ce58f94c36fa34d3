#include "BlindRun.hpp"
#include "Commands.hpp"
#include "EvaluateThesis.hpp"
#include "Progress.hpp"
#include "Shard.hpp"

#include "io/InputError.hpp"

#include <CLI/CLI.hpp>
#include <atomic>
#include <fmt/core.h>
#include <mutex>
#include <thread>

namespace naocal {

namespace {

struct EvaluateCommand {
  BlindPlan plan;
  std::string out, shard = "0/1", json, page;
  unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
  bool full = false;
  std::vector<std::string> shards;
};

/// Asks all sets that have no answer yet, several at a time.
void askAll(const BlindRun& run, const std::vector<std::size_t>& numbers, unsigned jobs) {
  const Progress progress{"sets answered"};
  std::atomic<std::size_t> next = 0, done = 0;
  std::atomic<bool> stopped = false;
  std::mutex telling;
  std::string problem;
  const auto work = [&] {
    for (std::size_t i = next++; i < numbers.size() && !stopped; i = next++) {
      try {
        if (!run.answered(numbers[i]) && !run.ask(numbers[i])) {
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

void evaluateEffects(EvaluateCommand command) {
  if (command.full) { // what the figures are promised for
    command.plan.controls = 1000;
    command.plan.sets = 40;
    command.plan.pictureShare = 0.2;
  }
  command.plan.out = command.out;
  const BlindRun run{command.plan};
  const auto [part, parts] = readShard(command.shard);
  std::vector<std::size_t> numbers;
  for (std::size_t number = part; number < run.size(); number += parts) {
    numbers.push_back(number);
  }
  askAll(run, numbers, command.jobs);
  if (Progress::interrupted()) {
    fmt::print("stopped; the answers so far are kept, the same command goes on\n");
  }
  judgeBlindly(command.out, command.json, command.page);
}

/// Brings seals, truths and answers of all shards into one folder and judges them; files are of the thesis's
/// evaluation.
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
  judgeBlindly(command.out, command.json, command.page);
}

void addReports(CLI::App& app, EvaluateCommand& command) {
  app.add_option("--json", command.json, "the evaluation as JSON to a file, or - for standard output");
  app.add_option("--page", command.page, "a page with plots");
}

} // namespace

void addEvaluate(CLI::App& app) {
  CLI::App* evaluate =
      app.add_subcommand("evaluate", "how good the tool is, measured on many robots whose truth is known");
  evaluate->require_subcommand(1);

  auto asked = std::make_shared<EvaluateCommand>();
  CLI::App* effects =
      evaluate->add_subcommand("effects", "a blind benchmark of the diagnosis: hidden effects, sealed truths");
  effects->footer("Example: naocal evaluate effects --out /tmp/blind --page /tmp/blind.html\n"
                  "Stopped with Ctrl-C or killed, the same command goes on where it was.");
  effects->add_option("--out", asked->out, "the folder for sets, seals and answers")->required();
  effects->add_option("--seed", asked->plan.seed, "another benchmark for every seed")->capture_default_str();
  effects->add_option("--controls", asked->plan.controls, "robots without effect, per noise regime")
      ->capture_default_str();
  effects->add_option("--sets", asked->plan.sets, "robots per effect and size, and per case otherwise")
      ->capture_default_str();
  effects->add_option("--pictures", asked->plan.pictureShare, "share that is rendered")->check(CLI::Range(0.0, 0.9));
  effects->add_option(
      "--only", asked->plan.only,
      "one group: control, decoy, catalogue, pair, outside, absorbed, corrupted, sized, camera, twin, event, jitter");
  effects->add_option("--shard", asked->shard, "i/n: only every n-th set, from the i-th on (counted from 0)");
  effects->add_option("--jobs", asked->jobs, "sets at a time")->check(CLI::PositiveNumber);
  effects->add_flag("--full", asked->full,
                    "the full table: 1000 controls per regime, 40 sets per cell, a fifth rendered");
  effects->add_flag("--keep", asked->plan.keep, "keep the sets after their answers");
  addReports(*effects, *asked);
  effects->callback([asked] { evaluateEffects(*asked); });

  auto merged = std::make_shared<EvaluateCommand>();
  CLI::App* merge = evaluate->add_subcommand("merge", "judges the shards of an evaluation together");
  merge->footer("Example: naocal evaluate merge --out /tmp/all shard0 shard1 --json evaluation.json\n"
                "         naocal evaluate merge part0.json part1.json --json evaluation.json");
  merge
      ->add_option("SHARDS", merged->shards,
                   "folders of 'naocal evaluate effects', or files of 'naocal evaluate thesis'")
      ->required();
  merge->add_option("--out", merged->out, "the folder that gets all of them, where they are folders");
  addReports(*merge, *merged);
  merge->callback([merged] { mergeShards(*merged); });
  addEvaluateNext(*evaluate);
  addEvaluateThesis(*evaluate);
}

} // namespace naocal
