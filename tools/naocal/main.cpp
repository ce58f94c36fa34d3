#include "commands/Commands.hpp"
#include "console/CommandTable.hpp"
#include "console/Program.hpp"

namespace {

void complete(CLI::App& app, int& exitCode) {
  naocal::addCheck(app, exitCode);
  naocal::addSolve(app, exitCode);
  naocal::addCompare(app);
  naocal::addDiagnose(app, exitCode);
  naocal::addEffects(app);
  naocal::addExplore(app);
  naocal::addApply(app, exitCode);
  naocal::addExport(app, exitCode);
  naocal::addHistory(app);
  naocal::addReplay(app, exitCode);
}

} // namespace

/// The commands without large libraries; for the others it becomes another program.
int main(int argc, char** argv) {
  return naocal::runProgram(naocal::mainProgram, complete, argc, argv);
}
