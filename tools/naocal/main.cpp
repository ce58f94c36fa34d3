#include "commands/Commands.hpp"

#include "io/InputError.hpp"
#include "math/Parallel.hpp"

#include <CLI/CLI.hpp>
#include <exception>
#include <fmt/core.h>

int main(int argc, char** argv) {
  naocal::tuneAllocator();
  CLI::App app{
      "naocal: a NAO calibrates its joints and cameras with printed boards on the floor, and says how sure it is.",
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
    fmt::print(stderr, "naocal: {} (naocal --help says what there is)\n", error.what());
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
