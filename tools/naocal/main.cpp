#include "commands/Commands.hpp"

#include "io/InputError.hpp"
#include "math/Parallel.hpp"

#include <CLI/CLI.hpp>
#include <exception>
#include <fmt/core.h>
#include <string>

int main(int argc, char** argv) {
  naocal::tuneAllocator();
  CLI::App app{"naocal: calibrates a robot's joints and cameras from pictures of printed boards, with uncertainties.",
               "naocal"};
  app.set_version_flag("--version", NAOCAL_VERSION);
  app.require_subcommand(1);
  app.footer("Example: naocal simulate /tmp/set && naocal solve /tmp/set -o /tmp/result.json");
  int exitCode = 0;
  naocal::addSimulate(app);
  naocal::addDetect(app);
  naocal::addSolve(app, exitCode);
  naocal::addCompare(app);
  naocal::addEffects(app);
  naocal::addDiagnose(app, exitCode);
  naocal::addExplore(app);
  naocal::addPoses(app);
  naocal::addReport(app);
  naocal::addDemo(app, exitCode);
  naocal::addEvaluate(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      return app.exit(error); // --help, --version
    }
    std::string command = "naocal"; // whose help tells more
    for (const CLI::App* at = &app; !at->get_subcommands().empty();) {
      at = at->get_subcommands().front();
      command += " " + at->get_name();
    }
    fmt::print(stderr, "naocal: {} (see '{} --help')\n", error.what(), command);
    return 2;
  } catch (const naocal::InputError& error) {
    fmt::print(stderr, "naocal: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "naocal: {}\n", error.what());
    return 1;
  }
  return exitCode;
}
