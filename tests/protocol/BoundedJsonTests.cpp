#include "protocol/BoundedJson.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>

namespace naocal {

TEST_CASE("brackets without end are refused before they exhaust the stack") {
  // Proves the boundary for lists and objects: 100 levels are accepted, 101 are not, closed or not.
  CHECK(parseBoundedJson(R"({"a": [1, 2]})")["a"][1] == 2);
  CHECK_NOTHROW(parseBoundedJson(std::string(100, '[') + "1" + std::string(100, ']')));
  CHECK_THROWS_WITH(parseBoundedJson(std::string(101, '[') + std::string(101, ']')),
                    Catch::Contains("expected at most 100 levels of brackets, found more"));
  std::string objects = "1";
  for (int i = 0; i < 100; ++i) {
    objects = "{\"a\":" + objects + "}";
  }
  CHECK_NOTHROW(parseBoundedJson(objects));
  CHECK_THROWS_AS(parseBoundedJson("[" + objects + "]"), nlohmann::json::exception);
  CHECK_THROWS_AS(parseBoundedJson(std::string(100000, '[')), nlohmann::json::exception);
  CHECK_THROWS_AS(parseBoundedJson("{"), nlohmann::json::exception);
}

TEST_CASE("comments are read only where they are allowed") {
  // Proves it for both kinds of comments, and that the refusal's reason has no prefix of the library.
  const char* const text = "{\"a\": 1 /* one */} // end";
  CHECK(parseBoundedJson(text, true)["a"] == 1);
  try {
    parseBoundedJson(text);
    FAIL("comments were read");
  } catch (const nlohmann::json::exception& error) {
    CHECK(parseErrorReason(error).rfind("parse error at line 1", 0) == 0);
  }
}

TEST_CASE("whatever a value holds, its text is JSON on one line") {
  // Proves it for invalid UTF-8, line breaks, and infinity.
  const nlohmann::json value = {{"b", "\xff\n"}, {"a", std::numeric_limits<double>::infinity()}};
  CHECK(jsonText(value) == "{\"a\":null,\"b\":\"\xef\xbf\xbd\\n\"}");
  CHECK(jsonLine(value) == jsonText(value) + "\n");
}

} // namespace naocal
