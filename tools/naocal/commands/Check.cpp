#include "commands/Commands.hpp"
#include "console/OutputFiles.hpp"
#include "console/Progress.hpp"
#include "console/print/PrintText.hpp"

#include "command-line/OptionChecks.hpp"
#include "inspection/CaptureSetCheck.hpp"
#include "io/FileVersion.hpp"

#include <CLI/CLI.hpp>
#include <cctype>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

namespace naocal {

namespace {

struct CheckCommand {
  std::string set, json;
  bool all = false;
};

nlohmann::json checkJson(const CheckCommand& command, const CaptureSetCheck& check) {
  nlohmann::json document = withFormat("naocal-check", {{"set", command.set},
                                                        {"captures", check.captures},
                                                        {"poses", check.poses},
                                                        {"problems", nlohmann::json::array()}});
  for (const SetProblem& problem : check.problems) {
    document["problems"].push_back({{"number", document["problems"].size() + 1},
                                    {"severity", toString(problem.severity)},
                                    {"kind", problem.kind},
                                    {"sentence", problem.sentence}});
  }
  return document;
}

/// The sentence without numbers and quoted names: equal for problems of one kind at different places.
std::string pattern(const std::string& sentence) {
  std::string result;
  bool isQuoted = false;
  for (const char character : sentence) {
    isQuoted = character == '"' ? !isQuoted : isQuoted;
    if (!isQuoted && std::isdigit(static_cast<unsigned char>(character)) == 0 && character != '-' && character != '.') {
      result += character;
    }
  }
  return result;
}

/// Prints the problems with their numbers, of those alike a few unless all are wanted.
void printProblems(const CaptureSetCheck& check, bool all) {
  constexpr std::size_t shown = 3;
  const std::map<Severity, std::string> heads{{Severity::refused, "refused: a calibration cannot use it"},
                                              {Severity::doubtful, "doubtful: can be used, but a result may be wrong"},
                                              {Severity::remark, "remarks"}};
  std::map<std::string, std::size_t> counts, printed;
  for (const SetProblem& problem : check.problems) {
    ++counts[problem.kind + pattern(problem.sentence)];
  }
  const SetProblem* previous = nullptr;
  for (std::size_t i = 0; i < check.problems.size(); ++i) {
    const SetProblem& problem = check.problems[i];
    if (previous == nullptr || previous->severity != problem.severity) {
      printText("{}:\n", heads.at(problem.severity));
    }
    previous = &problem;
    const std::string alike = problem.kind + pattern(problem.sentence);
    const std::size_t number = ++printed[alike];
    if (all || number <= shown) {
      printText("{:>4}  {}\n", i + 1, problem.sentence);
    } else if (number == shown + 1) {
      printText("      {} more like the last of these (--all prints them)\n", counts[alike] - shown);
    }
  }
}

} // namespace

void addCheck(CLI::App& app, int& exitCode) {
  const auto command = std::make_shared<CheckCommand>();
  CLI::App* const checker = app.get_subcommand("check");
  checker->footer("Example: naocal check captures/\nExit code: 0 no problem, 3 problems, 2 not a capture set");
  checker->add_option("SET", command->set, "a folder with captures.json")->type_name("FOLDER")->required();
  checker->add_option("--json", command->json, "write the problems to this file, or - for standard output")
      ->type_name("FILE")
      ->check(replaceableFile("naocal-check"));
  checker->add_flag("--all", command->all, "print all problems, also where many are alike");
  checker->callback([command, &exitCode] {
    const Progress progress{"pictures"};
    const CaptureSetCheck check =
        checkCaptureSet(command->set, [&](std::size_t done, std::size_t all) { return progress(done, all); });
    exitCode = check.problems.empty() ? 0 : 3;
    if (!command->json.empty()) {
      writeJson(checkJson(*command, check), command->json);
    }
    if (command->json != "-") {
      printProblems(check, command->all);
      printText("{}: {} captures, {} poses, {} problem{}\n", command->set, check.captures, check.poses,
                check.problems.empty() ? "no" : std::to_string(check.problems.size()),
                check.problems.size() == 1 ? "" : "s");
      if (Progress::wasInterrupted()) {
        printText("stopped: not all pictures were looked at\n");
      }
    }
  });
}

} // namespace naocal
