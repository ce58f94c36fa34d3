#include "commands/Commands.hpp"

#include "io/Failure.hpp"
#include "io/InputError.hpp"
#include "math/Parallel.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <string>
#include <vector>

namespace {

/// Throws InputError if the first word is no command.
void requireCommand(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  if (!word.starts_with('-') && std::find(names.begin(), names.end(), word) == names.end()) {
    throw naocal::InputError{
        fmt::format("'{}' is no command; near it are {}", word, fmt::join(naocal::closestNames(word, names), ", "))};
  }
}

} // namespace

int main(int argc, char** argv) {
  naocal::endWithSentence("naocal");
  naocal::tuneAllocator();
  CLI::App app{"naocal: calibrates a robot's joints and cameras from pictures of printed boards, with uncertainties.",
               "naocal"};
  app.set_version_flag("--version", NAOCAL_VERSION);
  app.require_subcommand(1);
  app.footer("Example: naocal simulate /tmp/set && naocal solve /tmp/set -o /tmp/result.json");
  int exitCode = 0;
  constexpr std::size_t most = naocal::longestSentence;
  naocal::addSimulate(app);
  naocal::addCheck(app, exitCode);
  naocal::addDetect(app);
  naocal::addSolve(app, exitCode);
  naocal::addCompare(app);
  naocal::addEffects(app);
  naocal::addDiagnose(app, exitCode);
  naocal::addExplore(app);
  naocal::addPoses(app);
  naocal::addReport(app);
  naocal::addApply(app);
  naocal::addExport(app);
  naocal::addImport(app);
  naocal::addBoard(app);
  naocal::addReplay(app, exitCode);
  naocal::addDemo(app, exitCode);
  naocal::addEvaluate(app);
  try {
    if (argc > 1) {
      requireCommand(app, argv[1]);
    }
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      return app.exit(error); // --help, --version
    }
    std::string command = "naocal"; // the command whose help is suggested
    for (const CLI::App* at = &app; !at->get_subcommands().empty();) {
      at = at->get_subcommands().front();
      command += " " + at->get_name();
    }
    const std::string said = fmt::format("{} (see '{} --help')", naocal::printableText(error.what(), most), command);
    fmt::print(stderr, "naocal: {}\n", said);
    return 2;
  } catch (const std::exception& error) {
    const naocal::Failure failure = naocal::describeFailure(error);
    fmt::print(stderr, "naocal: {}\n", naocal::printableText(failure.sentence, most));
    return failure.exitCode;
  }
  return exitCode;
}
