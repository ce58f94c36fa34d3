#include "commands/Commands.hpp"
#include "console/CommandLine.hpp"
#include "console/OutputFiles.hpp"
#include "console/Progress.hpp"
#include "console/print/PrintText.hpp"

#include "command-line/OptionChecks.hpp"
#include "evaluation/NextPosesTrial.hpp"
#include "io/FileVersion.hpp"
#include "io/InputError.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

namespace naocal {

namespace {

struct NextCommand {
  std::size_t robots = 100;
  std::uint64_t seed = 1;
  unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
  std::string json;
  NextPosesTrialOptions options;
};

/// Runs one trial per robot, several at a time; after Ctrl-C returns the finished ones.
std::vector<NextPosesTrial> trials(const NextCommand& command) {
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  const Progress progress{"robots"};
  std::vector<NextPosesTrial> result;
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> stopped = false;
  std::mutex adding;
  std::string problem;
  const auto work = [&] {
    for (std::size_t i = next++; i < command.robots && !stopped; i = next++) {
      try {
        NextPosesTrial trial = runNextPosesTrial(robot, command.seed + i, command.options);
        const std::lock_guard lock{adding};
        result.push_back(std::move(trial));
      } catch (const std::exception& error) {
        const std::lock_guard lock{adding};
        problem = error.what();
        stopped = true;
      }
      const std::lock_guard lock{adding};
      stopped = stopped || !progress(result.size(), command.robots);
    }
  };
  std::vector<std::thread> workers;
  for (unsigned job = 0; job < command.jobs; ++job) {
    workers.emplace_back(work);
  }
  for (std::thread& worker : workers) {
    worker.join();
  }
  if (!problem.empty()) {
    throw InputError{problem};
  }
  std::sort(result.begin(), result.end(),
            [](const NextPosesTrial& a, const NextPosesTrial& b) { return a.seed < b.seed; });
  return result;
}

/// Result of one selection strategy, over the robots with open questions after the first captures.
struct Summary {
  std::size_t certain = 0, right = 0;
  std::optional<std::size_t> median; // absent: at least half of the robots never became certain
};

Summary summary(const std::vector<NextPosesTrial>& open, TrialArm NextPosesTrial::*arm) {
  Summary result;
  std::vector<std::size_t> poses;
  for (const NextPosesTrial& trial : open) {
    const TrialArm& here = trial.*arm;
    result.certain += here.poses.has_value();
    result.right += here.right;
    poses.push_back(here.poses.value_or(std::numeric_limits<std::size_t>::max()));
  }
  std::sort(poses.begin(), poses.end());
  if (!poses.empty() && poses[poses.size() / 2] != std::numeric_limits<std::size_t>::max()) {
    result.median = poses[poses.size() / 2];
  }
  return result;
}

nlohmann::json summaryJson(const Summary& summary) {
  return {{"certain", summary.certain},
          {"right", summary.right},
          {"medianPoses", summary.median ? nlohmann::json(*summary.median) : nlohmann::json(nullptr)}};
}

nlohmann::json armJson(const TrialArm& arm) {
  return {{"poses", arm.poses ? nlohmann::json(*arm.poses) : nlohmann::json(nullptr)}, {"right", arm.right}};
}

void evaluateNext(const NextCommand& command) {
  const std::vector<NextPosesTrial> all = trials(command);
  std::vector<NextPosesTrial> open = all;
  std::erase_if(open, [](const NextPosesTrial& trial) { return trial.suspects.empty(); });
  const Summary proposed = summary(open, &NextPosesTrial::proposed), random = summary(open, &NextPosesTrial::random);
  if (!command.json.empty()) {
    nlohmann::json list = nlohmann::json::array();
    for (const NextPosesTrial& trial : open) {
      list.push_back({{"seed", trial.seed},
                      {"hidden", trial.hidden},
                      {"suspects", trial.suspects},
                      {"proposed", armJson(trial.proposed)},
                      {"random", armJson(trial.random)}});
    }
    writeJson(withFormat("naocal-next-evaluation", {{"robots", all.size()},
                                                    {"open", open.size()},
                                                    {"start", command.options.start},
                                                    {"certainty", command.options.certainty},
                                                    {"proposed", summaryJson(proposed)},
                                                    {"random", summaryJson(random)},
                                                    {"trials", list}}),
              command.json);
  }
  if (command.json == "-") {
    return;
  }
  printText("{} robots with a hidden effect; after {} random poses the class of {} was open\n", all.size(),
            command.options.start, open.size());
  for (const auto& [name, arm] : {std::pair{"proposed", proposed}, {"random", random}}) {
    printText("  {:9} poses: {} further ones until {:.0f} % certain (median), certain {} of {}, right {}\n", name,
              arm.median ? fmt::format("{:2}", *arm.median) : fmt::format("more than {}", command.options.most),
              100 * command.options.certainty, arm.certain, open.size(), arm.right);
  }
}

} // namespace

void addEvaluateNext(CLI::App& evaluate) {
  auto command = std::make_shared<NextCommand>();
  CLI::App* next = evaluate.add_subcommand(
      "next", "how many further poses it takes to tell effects apart: proposed ones against random stable ones");
  next->footer("Example: naocal evaluate next --robots 100 --json next.json");
  next->add_option("--robots", command->robots, "each with a hidden effect")
      ->check(wholeNumber(1, 1'000'000))
      ->capture_default_str();
  next->add_option("--seed", command->seed, "of the first robot")->capture_default_str();
  next->add_option("--start", command->options.start, "random poses before the first question")
      ->check(wholeNumber(4, 1000))
      ->capture_default_str();
  next->add_option("--flaw-scale", command->options.flawScale, "of the hidden effect, against a worn NAO's")
      ->group(expertOptions)
      ->check(number(0.01, 10.0))
      ->capture_default_str();
  next->add_option("--most", command->options.most, "further poses until it is given up")
      ->check(wholeNumber(0, 1000))
      ->capture_default_str();
  next->add_option("--certainty", command->options.certainty, "that is enough")
      ->group(expertOptions)
      ->check(number(0.5, 0.9999))
      ->capture_default_str();
  next->add_option("--jobs", command->jobs, "robots at a time")->group(expertOptions)->check(wholeNumber(1, 1024));
  next->add_option("--json", command->json, "the evaluation as JSON to a file, or - for standard output")
      ->type_name("FILE")
      ->check(replaceableFile("naocal-next-evaluation"));
  next->callback([command] { evaluateNext(*command); });
}

} // namespace naocal
