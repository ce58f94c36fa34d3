#include "console/Program.hpp"

#include "console/CommandTable.hpp"
#include "console/Subprocess.hpp"

#include "command-line/Parsing.hpp"
#include "io/Failure.hpp"
#include "io/InputError.hpp"
#include "io/Programs.hpp"
#include "math/Parallel.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <string>

namespace naocal {

namespace {

int run(std::string_view program, CompleteCommands complete, int argc, char** argv) {
  const CommandEntry* const asked = argc > 1 ? findCommand(argv[1]) : nullptr;
  if (asked != nullptr && asked->program != program) {
    becomeProgram(requireProgram(std::string{asked->program}), argv);
  }
  CLI::App app{"naocal: calibrates a robot's joints and cameras from pictures of printed boards, with uncertainties.",
               std::string{mainProgram}};
  useHelp(app);
  app.set_version_flag("--version", NAOCAL_VERSION, "print the version");
  app.require_subcommand(1);
  addTable(app); // before the footer, which commands would inherit
  app.footer("Example: naocal simulate /tmp/set && naocal solve /tmp/set -o /tmp/result.json\n"
             "Each command has its own --help, and a manual page: man naocal-solve.");
  int exitCode = 0;
  complete(app, exitCode);
  tuneAllocator();
  return parseCommandLine(app, argc, argv).value_or(exitCode);
}

} // namespace

int runProgram(std::string_view program, CompleteCommands complete, int argc, char** argv) {
  endWithSentence("naocal");
  try {
    return run(program, complete, argc, argv);
  } catch (const std::exception& error) {
    const Failure failure = describeFailure(error);
    fmt::print(stderr, "naocal: {}\n", printableText(failure.sentence, longestSentence));
    return failure.exitCode;
  }
}

} // namespace naocal
