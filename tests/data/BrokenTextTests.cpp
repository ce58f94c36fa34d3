#include "GoodSet.hpp"
#include "data/CaptureSetFile.hpp"
#include "data/Refusal.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

namespace naocal {
namespace {

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  return text.replace(text.find(part), part.size(), by);
}

} // namespace

TEST_CASE("broken syntax is refused with line and column") {
  // Proves line and column for common syntax errors; the JSON parser's own message is not tested.
  CHECK_THAT(refusal(""), Catch::Contains("captures.json: expected valid JSON") && Catch::Contains("line 1, column 1"));
  CHECK_THAT(refusal("{\n \"format\" \"x\"}"), Catch::Contains("line 2, column 13"));
  CHECK_THAT(refusal("{\n \"format\": \"x\",\n}"), Catch::Contains("line 3, column 1"));
  CHECK_THAT(refusal("{} {}"), Catch::Contains("line 1, column 4"));
  CHECK_THAT(refusal("{\"a\": \"\xff\"}"), Catch::Contains("UTF-8"));
  CHECK_THAT(refusal("{\"a\": 1e999}"), Catch::Contains("1e999"));
  CHECK_THAT(refusal("[]"), Catch::Contains("top level: expected an object, found a list of 0"));
  CHECK_THAT(refusal(std::string(100000, '[')), Catch::Contains("levels of brackets"));
  CHECK_THAT(refusal(std::string(101, '[') + std::string(101, ']')), Catch::Contains("at most 100 levels of brackets"));
  CHECK_THAT(refusal(std::string(100, '[') + std::string(100, ']')), Catch::Contains("top level: expected an object"));
}

TEST_CASE("names and numbers of captures have limits") {
  // Proves both at their boundary, and that a text with a zero byte, which would be cut there, is refused.
  auto set = goodSet();
  const auto named = [&](const std::string& name) {
    set["robot"]["bodyId"] = name;
    return refusal(set.dump());
  };
  CHECK(named(std::string(longestText, 'n')) == "not refused");
  CHECK_THAT(named(std::string(longestText + 1, 'n')),
             Catch::Contains("robot.bodyId: expected a text of at most 10000 bytes, found one of 10001"));
  CHECK_THAT(named(std::string("a\0b", 3)), Catch::Contains("robot.bodyId: expected a text without zero bytes"));
  set["robot"]["bodyId"] = "nao7";
  set["captures"] = nlohmann::json(mostCaptures + 1, nullptr);
  CHECK_THAT(refusal(set.dump()), Catch::Contains("captures: expected at most 20000 captures in a set; split it into "
                                                  "several, found 20001"));
  set["captures"].erase(0);
  CHECK_THAT(refusal(set.dump()), Catch::Contains("captures[0]"));
}

TEST_CASE("a key that occurs twice is refused with its place") {
  // Proves it at the top level, in an object and in a list element.
  CHECK_THAT(refusal(R"({"a": 1, "a": 1})"), Catch::Contains("top level") && Catch::Contains("\"a\" twice"));
  CHECK_THAT(refusal(R"({"b": {"a": 1, "c": {"a": 2}, "a": 1}})"), Catch::Contains("json: b:"));
  CHECK_THAT(refusal(R"({"captures": [{"a": 1}, {"a": [{}, 2], "a": 1}]})"), Catch::Contains("captures[1]:"));
}

TEST_CASE("a number literal that JSON does not know spoils its capture only") {
  // Proves it for the literals that Python writes; strings that contain them are unchanged.
  const std::string text = goodSet().dump();
  for (const char* literal : {"NaN", "Infinity", "-Infinity"}) {
    const std::string broken = replaced(text, "-0.21", literal);
    const auto read = parseCaptureSet(broken, "captures.json", BadCapturePolicy::skip);
    CHECK(read.set.captures.size() == 3);
    REQUIRE(read.skipped.size() == 1);
    CHECK_THAT(read.skipped[0], Catch::Contains("captures[0].joints.commanded[1]") && Catch::Contains(literal));
  }
  const auto parsed = parseJson(R"({"NaN\"NaN": [NaN, -Infinity, "Infinity NaN", "\\", NaN]})", "file");
  CHECK(parsed.dump() == R"({"NaN\"NaN":["NaN","-Infinity","Infinity NaN","\\","NaN"]})");
  CHECK_THAT(refusal("{\"a\": NaN,\n \"b\" 1}"), Catch::Contains("line 1, column 7"));
}

TEST_CASE("a truncated file is refused") {
  // Proves that a file cut at every 50th byte is refused as invalid JSON.
  const std::string text = formatCaptureSet(parseCaptureSet(goodSet().dump(), "set").set);
  for (std::size_t length = 0; length + 2 < text.size(); length += 50) {
    INFO(length);
    CHECK_THAT(refusal(text.substr(0, length)), Catch::Contains("expected valid JSON"));
  }
}

} // namespace naocal
