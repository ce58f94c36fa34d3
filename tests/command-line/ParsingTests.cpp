#include "command-line/Parsing.hpp"

#include "io/InputError.hpp"

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

using namespace naocal;

namespace {

/// Parses a command line with the commands `solve SET... --with --output` and `evaluate thesis`.
void parse(std::vector<std::string> words) {
  CLI::App app{"a program", "program"};
  useHelp(app);
  app.require_subcommand(1);
  std::vector<std::string> sets, with;
  std::string output, near;
  CLI::App* const solve = app.add_subcommand("solve", "solves");
  solve->add_option("SET", sets, "folders")->required();
  solve->add_option("--with", with, "effects")->type_name("EFFECT@PLACE");
  CLI::Option* const file = solve->add_option("--output", output, "result")->type_name("FILE");
  solve->add_option("--near", near, "a place")->type_name("PLACE")->needs(file);
  app.add_subcommand("evaluate", "evaluates")->require_subcommand(1)->add_subcommand("thesis", "tables");
  words.insert(words.begin(), "program");
  std::vector<char*> arguments;
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  parseCommandLine(app, static_cast<int>(words.size()), arguments.data());
}

} // namespace

// Proves the sentence for each kind of wrong usage: what is wrong, what is near, and which help to ask for.
TEST_CASE("wrong usage is answered with one sentence and the fitting help") {
  CHECK_THROWS_WITH(parse({"sovle", "a"}),
                    "'sovle' is no command of program; near it are solve and evaluate (see 'program --help')");
  CHECK_THROWS_WITH(
      parse({"solve", "--wiht", "a"}),
      "'--wiht' is no option of program solve; near it are --with, --help and --near (see 'program solve --help')");
  CHECK_THROWS_WITH(parse({"solve"}), "expected SET...: folders; found none (see 'program solve --help')");
  CHECK_THROWS_WITH(parse({"solve", "a", "--output"}),
                    "--output: expected FILE, found nothing (see 'program solve --help')");
  CHECK_THROWS_WITH(parse({"solve", "a", "--near", "b"}),
                    "--near: expected --output beside it, found none (see 'program solve --help')");
  CHECK_THROWS_WITH(parse({"evaluate"}), "expected a command: thesis; found none (see 'program evaluate --help')");
  CHECK_THROWS_WITH(parse({"evaluate", "thesiss"}),
                    "'thesiss' is no command of program evaluate; near it is thesis (see 'program evaluate --help')");
  CHECK_THROWS_AS(parse({}), InputError);
  CHECK_NOTHROW(parse({"solve", "a", "b", "--with", "c@d", "--output", "e", "--near", "f"}));
}
