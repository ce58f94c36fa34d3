#include "command-line/HelpFormatter.hpp"

#include "command-line/OptionChecks.hpp"
#include "command-line/Parsing.hpp"
#include "command-line/TextLayout.hpp"

#include <catch2/catch.hpp>
#include <cstddef>
#include <string>
#include <vector>

using namespace naocal;

namespace {

/// A command with an option of each kind.
struct Example {
  CLI::App app{"a program", "program"};
  std::size_t count = 8;
  double noise = 0.3;
  bool isQuick = false;
  std::string file, foot = "left";
  std::vector<std::string> sets;

  Example() {
    useHelp(app);
    CLI::App* const command = app.add_subcommand("solve", "solves");
    command->group("Calibrate");
    command->add_option("SET", sets, "folders")->required();
    command->add_option("-o,--output", file, "to be written")->type_name("FILE");
    command->add_option("--count", count, "how many")->check(wholeNumber(1, 1000))->capture_default_str();
    command->add_option("--foot", foot, "to stand on")->check(oneOf(std::vector<std::string>{"left", "right"}));
    command->add_option("--noise", noise, "of a corner [px]")->check(number(0, 10))->group(expertOptions);
    command->add_flag("!--slow", isQuick, "takes its time");
  }
};

} // namespace

// Proves the whole help of a command: usage, arguments, defaults and ranges, words in place of a value, experts last.
TEST_CASE("help names values, defaults and ranges") {
  const Example example;
  CHECK(example.app.get_subcommand("solve")->help("program") == "solves\n\n"
                                                                "Usage: program solve [OPTIONS] SET...\n\n"
                                                                "  SET...             folders\n\n"
                                                                "Options:\n"
                                                                "  -o, --output FILE  to be written\n"
                                                                "  --count N          how many (default 8; 1 to 1000)\n"
                                                                "  --foot left|right  to stand on\n"
                                                                "  --slow             takes its time\n"
                                                                "  -h, --help         print this help\n\n"
                                                                "Expert options:\n"
                                                                "  --noise NUMBER     of a corner [px] (0 to 10)\n");
}

// Proves that a program's help lists its commands under their groups.
TEST_CASE("help lists commands in groups") {
  const Example example;
  CHECK(example.app.help().find("Calibrate:\n  solve       solves\n") != std::string::npos);
}

// Proves that rows are wrapped by columns, not by bytes, and that a long head has its text below.
TEST_CASE("rows are wrapped beside their heads") {
  CHECK(layOutRow("--a", "one two three", 8, 15) == "  --a   one two\n        three\n");
  CHECK(layOutRow("--ä", "±±± ±±±", 8, 15) == "  --ä   ±±± ±±±\n");
  CHECK(layOutRow("--long-name", "one", 8, 15) == "  --long-name\n        one\n");
  CHECK(wrapText("  one two three", 9, 2) == "  one two\n    three\n");
  CHECK(joinWords({"a", "b", "c"}, "or") == "a, b or c");
}
