#include "TemporaryFolder.hpp"
#include "io/FileKind.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {

TEST_CASE("a file is replaced by one of its own kind only") {
  // Proves that absent and empty files and files of the same format are replaced, and that all others keep their bytes.
  const TemporaryFolder folder;
  const auto file = folder.path() / "result.json";
  const nlohmann::json result{{"format", "naocal-result"}, {"version", 1}};
  replaceJson(file, result);
  replaceJson(file, result);
  CHECK(nlohmann::json::parse(readFile(file)) == result);
  for (const std::string other : {"{}", "words", R"({"format": "naocal-poses"})", "<!doctype html><p>"}) {
    writeAtomically(file, other);
    CHECK_THROWS_AS(replaceJson(file, result), InputError);
    CHECK(readFile(file) == other);
  }
  writeAtomically(file, "");
  replaceJson(file, result);
  CHECK(nlohmann::json::parse(readFile(file)) == result);
}

} // namespace naocal
