#include "command-line/OptionChecks.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

using namespace naocal;

namespace {

/// The sentence with which a check refuses a text; empty if it accepts it.
std::string refusal(const CLI::Validator& check, std::string text) {
  return check(text);
}

} // namespace

// Proves the range of whole numbers at its ends, and that signs, blanks, fractions and words are refused. Seeds beyond
// the signed range are accepted where there is no upper end.
TEST_CASE("a whole number is accepted in its range only") {
  const CLI::Validator check = wholeNumber(1, 1000);
  for (const char* text : {"1", "1000", "007"}) {
    CHECK(refusal(check, text).empty());
  }
  for (const char* text :
       {"0", "1001", "-4", "+4", " 4", "4 ", "4.0", "4e2", "0x4", "", "four", "99999999999999999999"}) {
    CHECK(refusal(check, text) == "expected a whole number, 1 to 1000, found \"" + std::string{text} + "\"");
  }
  CHECK(refusal(wholeNumber(0), "18446744073709551615").empty());
  CHECK_FALSE(refusal(wholeNumber(0), "18446744073709551616").empty());
  CHECK_FALSE(refusal(wholeNumber(0), "-1").empty());
}

// Proves the range of numbers at its ends, and that what is not finite is refused, which CLI11's own range accepts.
TEST_CASE("a number is accepted in its range only, and only if it is finite") {
  const CLI::Validator check = number(0.001, 100);
  for (const char* text : {"0.001", "100", "1e1", ".5"}) {
    CHECK(refusal(check, text).empty());
  }
  for (const char* text : {"0", "-1", "100.1", "nan", "inf", "1e999", "", " 1", "1 px"}) {
    CHECK(refusal(check, text) == "expected a number from 0.001 to 100, found \"" + std::string{text} + "\"");
  }
  CHECK(refusal(positiveNumber(), "0") == "expected a number above 0, found \"0\"");
}

// Proves that words are compared letter by letter, and names of values without regard to case.
TEST_CASE("a word is one of the list, a name is replaced by its value") {
  CHECK(refusal(oneOf(std::vector<std::string>{"left", "both"}), "both").empty());
  CHECK(refusal(oneOf(std::vector<std::string>{"left", "right", "both"}), "Left") ==
        "expected left, right or both, found \"Left\"");
  enum class Foot { right, left };
  std::string text = "Left";
  CHECK(oneOf(std::map<std::string, Foot>{{"left", Foot::left}, {"right", Foot::right}})(text).empty());
  CHECK(text == "1");
}

// Proves that options without a check get one: a seed refuses a sign.
TEST_CASE("numbers without a range refuse what is no number") {
  CLI::App app{"", "program"};
  std::uint64_t seed = 0;
  double share = 0;
  CLI::App* const command = app.add_subcommand("command", "");
  command->add_option("--seed", seed, "");
  command->add_option("--share", share, "");
  checkNumbers(app);
  CHECK_THROWS_WITH(app.parse("command --seed -1"), "--seed: expected a whole number, 0 or more, found \"-1\"");
  CHECK_THROWS_AS(app.parse("command --share nan"), CLI::ValidationError);
  CHECK_NOTHROW(app.parse("command --seed 18446744073709551615 --share -1e3"));
  CHECK(seed == 18446744073709551615U);
}
