#include "commands/Commands.hpp"
#include "console/CommandTable.hpp"
#include "console/Program.hpp"

namespace {

void complete(CLI::App& app, int& /*exitCode*/) {
  naocal::addEvaluate(app);
}

} // namespace

/// The evaluation, with the other searches' libraries.
int main(int argc, char** argv) {
  return naocal::runProgram(naocal::evaluateProgram, complete, argc, argv);
}
