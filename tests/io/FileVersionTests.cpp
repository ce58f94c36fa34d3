#include "io/FileVersion.hpp"
#include "io/InputError.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

const std::string program = withFormat("any", Json::object())["writtenBy"];

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
                    program));
  document["writtenBy"] = "naocal 9.1.0";
  CHECK(refusal(document) == fmt::format("a.json: version: expected 1, found 3; naocal 9.1.0 wrote the file, this is "
                                         "{}; update this program",
                                         program));
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

TEST_CASE("a file begins with its format, its version and its program") {
  // Proves the keys, the program's form that people look for, and that `content` remains, in its order where it has
  // one.
  const Json written = withFormat("naocal-model", {{"with", Json::array()}, {"define", 2}});
  CHECK_THAT(written["writtenBy"].get<std::string>(), Catch::Matches("naocal [0-9]+\\.[0-9]+\\.[0-9]+"));
  CHECK(
      written ==
      Json{{"format", "naocal-model"}, {"version", 1}, {"writtenBy", program}, {"with", Json::array()}, {"define", 2}});
  CHECK(refusal(written) == "");
  CHECK(withFormatInOrder("naocal-boards", {{"z", 1}, {"a", 2}}).dump() ==
        fmt::format(R"({{"format":"naocal-boards","version":1,"writtenBy":"{}","z":1,"a":2}})", program));
}

} // namespace naocal
