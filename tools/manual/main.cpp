#include "BashCompletion.hpp"
#include "CommandText.hpp"
#include "FishCompletion.hpp"
#include "ManPage.hpp"
#include "ZshCompletion.hpp"

#include "io/Files.hpp"

#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace {

void writeIn(const std::filesystem::path& folder, const std::string& name, const std::string& text) {
  std::filesystem::create_directories(folder);
  naocal::writeAtomically(folder / name, text);
}

/// Writes pages and completions into man1, bash, zsh and fish of a folder.
void write(const naocal::manual::Manual& manual, const std::filesystem::path& folder) {
  using namespace naocal::manual;
  for (const Command& program : manual.programs) {
    writeIn(folder / "man1", program.name + ".1", manPage(program, program, manual.version));
    for (const Command& command : program.commands) {
      writeIn(folder / "man1", pageName(command.words) + ".1", manPage(command, program, manual.version));
    }
    writeIn(folder / "bash", program.name, bashCompletion(program, manual.effects));
    writeIn(folder / "zsh", "_" + program.name, zshCompletion(program, manual.effects));
    writeIn(folder / "fish", program.name + ".fish", fishCompletion(program, manual.effects));
  }
}

} // namespace

/// Writes manual pages and completions; run by the build, not installed.
/// Usage: write-manual FOLDER VERSION EFFECTS.json DESCRIPTION.json...
int main(int argc, char** argv) {
  if (argc < 5) {
    fmt::print(stderr, "usage: write-manual FOLDER VERSION EFFECTS.json DESCRIPTION.json...\n");
    return 2;
  }
  try {
    const std::vector<std::filesystem::path> descriptions{argv + 4, argv + argc};
    write({naocal::manual::readPrograms(descriptions), naocal::manual::readEffects(argv[3]), argv[2]}, argv[1]);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "write-manual: {}\n", error.what());
    return 2;
  }
}
