#include "io/FileVersion.hpp"
#include "io/InputError.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

/// The sentence that refuses the document; empty if none does.
std::string refusal(const Json& document, int newest = 1) {
  try {
    requireFormat(JsonCursor{document, "a.json"}, "naocal-model", newest);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("files of known versions are read, and newer ones refused with the program that wrote them") {
  // Proves the range of versions, and that nothing but a plausible name of a program reaches the sentence.
  Json document{{"format", "naocal-model"}, {"version", 1}};
  CHECK(refusal(document) == "");
  CHECK(refusal(document, 3) == ""); // an older one
  document["version"] = 3;
  CHECK(refusal(document, 3) == "");
  CHECK(refusal(document, 2) ==
        fmt::format("a.json: version: expected 1 to 2, found 3; a newer naocal wrote the file, this is {}; update this "
                    "program",
                    writtenBy()));
  document["writtenBy"] = "naocal 9.1.0";
  CHECK(refusal(document) == fmt::format("a.json: version: expected 1, found 3; naocal 9.1.0 wrote the file, this is "
                                         "{}; update this program",
                                         writtenBy()));
  for (const Json& nonsense : {Json(std::string(1000, 'A')), Json(17), Json("")}) {
    document["writtenBy"] = nonsense;
    CHECK_THAT(refusal(document), Catch::Contains("found 3; a newer naocal wrote"));
  }
  for (const Json& nonsense : {Json("1"), Json(0), Json(-1), Json(1.5), Json(nullptr)}) {
    document["version"] = nonsense;
    CHECK_THAT(refusal(document), Catch::Contains("version: expected a whole number from 1"));
  }
  document.erase("version");
  CHECK_THAT(refusal(document), Catch::Contains("expected the key \"version\""));
  document["format"] = "naocal-poses";
  CHECK_THAT(refusal(document), Catch::Contains("format"));
}

TEST_CASE("a file names the program and its version") {
  // Proves the form that people look for: a name, a blank and three numbers.
  CHECK_THAT(writtenBy(), Catch::Matches("naocal [0-9]+\\.[0-9]+\\.[0-9]+"));
}

} // namespace naocal
