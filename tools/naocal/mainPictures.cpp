#include "commands/Commands.hpp"
#include "console/CommandTable.hpp"
#include "console/Program.hpp"

namespace {

void complete(CLI::App& app, int& exitCode) {
  naocal::addDemo(app, exitCode);
  naocal::addSimulate(app);
  naocal::addBoard(app);
  naocal::addPoses(app);
  naocal::addDetect(app);
  naocal::addImport(app);
  naocal::addReport(app);
}

} // namespace

/// The commands with OpenCV and libharu.
int main(int argc, char** argv) {
  return naocal::runProgram(naocal::picturesProgram, complete, argc, argv);
}
