#include "commands/Commands.hpp"
#include "console/OutputFiles.hpp"
#include "console/RecordApplied.hpp"
#include "console/print/PrintHistory.hpp"
#include "console/print/PrintText.hpp"

#include "command-line/OptionChecks.hpp"
#include "io/InputError.hpp"
#include "runs/HistoryFile.hpp"
#include "runs/RunFolder.hpp"
#include "runs/RunWording.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace naocal {

namespace {

struct HistoryCommand {
  std::string robot, joint, fall, state, json;
};

/// Lists the files that are no runs on standard error, the first few of them.
void printBroken(const std::vector<std::string>& broken) {
  constexpr std::size_t shown = 5;
  for (std::size_t i = 0; i < std::min(shown, broken.size()); ++i) {
    printText(stderr, "left out: {}\n", broken[i]);
  }
  if (broken.size() > shown) {
    printText(stderr, "left out: {} more files like these\n", broken.size() - shown);
  }
}

void recordFall(const HistoryCommand& command, const RunFolder& runs, const std::vector<RobotHistory>& histories) {
  const auto time = command.fall == "now" ? std::optional{presentTime()} : parseTime(command.fall);
  if (!time) {
    throw InputError{
        fmt::format("--fall: expected a time in UTC such as \"2026-02-14 10:05\", or now, found \"{}\"", command.fall)};
  }
  const Run fall = runs.add({.time = *time,
                             .robot = findRobot(histories, command.robot).robot,
                             .kind = std::string{fallKind},
                             .by = "naocal history"});
  printText("recorded: a fall of {} on {} UTC\n", describeRobot(fall.robot), formatMinute(fall.time));
}

void print(const HistoryCommand& command, const std::vector<RobotHistory>& histories, const RunFolder& runs) {
  if (histories.empty()) {
    printText("No runs are recorded in {} yet: calibrations on a robot are, and results that 'naocal apply' sets.\n",
              runs.path().string());
    return;
  }
  for (const RobotHistory& history : histories) {
    if (command.joint.empty()) {
      printHistory(history);
    } else {
      printJointHistory(history, command.joint);
    }
    printText("\n");
  }
  printText("{}\nThe runs are recorded in {}.\n", describeRule(), runs.path().string());
}

void tellHistory(const HistoryCommand& command) {
  if (command.robot.empty() && !(command.joint.empty() && command.fall.empty())) {
    throw InputError{fmt::format("{}: expected the name of a robot before it, found none",
                                 command.joint.empty() ? "--fall" : "--joint")};
  }
  const RunFolder runs{runsFolder(command.state)};
  const RecordedRuns recorded = runs.read();
  printBroken(recorded.broken);
  std::vector<RobotHistory> histories = makeHistories(recorded.runs);
  if (!command.fall.empty()) {
    return recordFall(command, runs, histories);
  }
  if (!command.robot.empty()) {
    histories = {findRobot(histories, command.robot)};
  }
  if (!command.joint.empty()) {
    describeJoint(histories.front(), command.joint); // throws if no run has it
  }
  if (!command.json.empty()) {
    writeJson(historyJson(histories, runs.path().string(), recorded.broken), command.json);
  }
  if (command.json != "-") {
    print(command, histories, runs);
  }
}

} // namespace

void addHistory(CLI::App& app) {
  const auto command = std::make_shared<HistoryCommand>();
  CLI::App* const teller = app.get_subcommand("history");
  teller->footer("Example: naocal history nao21 --joint LKneePitch\n"
                 "Robots record their calibrations, 'naocal apply' what it sets, mate-bridge the runs it sees.");
  teller->add_option("ROBOT", command->robot, "its name or serial number; default: all robots")->type_name("NAME");
  teller->add_option("--joint", command->joint, "the offset of this joint over time, with falls and jumps")
      ->type_name("JOINT");
  teller
      ->add_option("--fall", command->fall,
                   "record that the robot fell: a time in UTC such as \"2026-02-14 10:05\", or now")
      ->type_name("TIME");
  teller->add_option("--state", command->state, stateHelp)->type_name("FOLDER")->group(expertOptions);
  teller->add_option("--json", command->json, "write the history as JSON to a file, or - for standard output")
      ->type_name("FILE")
      ->check(replaceableFile("naocal-history"));
  teller->callback([command] { tellHistory(*command); });
}

} // namespace naocal
