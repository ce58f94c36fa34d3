#include "blind/Bench.hpp"

#include <catch2/catch.hpp>

namespace blind {

TEST_CASE("a truth that was changed after sealing is refused, and so is an answer to another one") {
  // Proves that readCases detects a changed truth by its hash and an answer to another truth. The published hash in the
  // manifest is taken as authentic.
  Bench bench;
  bench.add(truthOf("s1", "control", json::array()), diagnosis("adequate"));
  CHECK(readCases(bench.path()).size() == 1);
  SECTION("truth") {
    std::string bytes = readFile(bench.path() / "truth" / "s1.sealed");
    bytes[10] = static_cast<char>(bytes[10] ^ 1);
    writeFile(bench.path() / "truth" / "s1.sealed", bytes);
    CHECK_THROWS_WITH(readCases(bench.path()), Catch::Contains("not the one that was sealed"));
  }
  SECTION("answer") {
    json answer = json::parse(readFile(bench.path() / "answers" / "s1.json"));
    answer["truthSha256"] = "0";
    writeFile(bench.path() / "answers" / "s1.json", answer.dump());
    CHECK_THROWS_WITH(readCases(bench.path()), Catch::Contains("another sealed truth"));
  }
}

} // namespace blind
