#include "io/InputError.hpp"

#include "io/Failure.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <new>
#include <stdexcept>

namespace naocal {

TEST_CASE("the nearest names are found, also for a name without end") {
  // Proves the order, and with a name of 16 million letters, which takes minutes without the limit, that only its first
  // letters are compared: at the boundary a further letter changes nothing.
  const std::vector<std::string> known{"LKneePitch", "RKneePitch", "HeadYaw"};
  CHECK(closestNames("LKnePitch", known, 2) == std::vector<std::string>{"LKneePitch", "RKneePitch"});
  CHECK(closestNames(std::string(std::size_t{1} << 24, 'A'), known).size() == 3);
  const std::string same(longestComparedName, 'x'), other = same.substr(1) + "y";
  CHECK(closestNames(same + "z", {other, same + "different"}, 1) == std::vector<std::string>{same + "different"});
}

TEST_CASE("no text of a file reaches a terminal as its command") {
  // Proves it for escape sequences, a carriage return, DEL and the control characters of UTF-8 in two bytes; other
  // letters, line feeds and tabs stay. Long texts are cut at the boundary.
  CHECK(printableText("\x1b]0;x\x07"
                      "A") == "\\x1b]0;x\\x07A");
  CHECK(printableText("a\rb\x7f") == "a\\x0db\\x7f");
  CHECK(printableText("\xc2\x9b"
                      "31m") == "\\x9b31m");
  CHECK(printableText("0.2° ± 1\n\tü\xc2\xa0") == "0.2° ± 1\n\tü\xc2\xa0");
  CHECK(printableText("\xc2") == "\xc2");
  CHECK(printableText("abc", 3) == "abc");
  CHECK(printableText("abcd", 3) == "abc...");
}

TEST_CASE("a program ends with a sentence of its own and the right exit code") {
  // Proves it for wrong input, a file that the system refuses, exhausted memory, numbers out of range, and others.
  CHECK(describeFailure(InputError{"a.json: no such file"}).sentence == "a.json: no such file");
  CHECK(describeFailure(InputError{""}).exitCode == 2);
  const std::filesystem::filesystem_error refused{"status", "/a/b", std::make_error_code(std::errc::permission_denied)};
  CHECK(describeFailure(refused).sentence ==
        "/a/b: the system refuses it: Permission denied; choose another place or change its permissions");
  CHECK(describeFailure(refused).exitCode == 2);
  CHECK(describeFailure(std::bad_alloc{}).sentence.starts_with("the memory is exhausted"));
  const Failure range = describeFailure(std::domain_error{"Error in function boost::math::students_t_distribution"});
  CHECK(range.exitCode == 2);
  CHECK(range.sentence.find("boost") == std::string::npos);
  CHECK(describeFailure(std::logic_error{"not reached"}).exitCode == 1);
}

} // namespace naocal
