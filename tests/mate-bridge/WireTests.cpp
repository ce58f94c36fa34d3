#include "server/Wire.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace naocal;

TEST_CASE("brackets without end are refused before they exhaust the stack") {
  // Proves the bound for what robots and pages send; shallow documents pass.
  CHECK(wireJson(R"({"a": [1, 2]})")["a"][1] == 2);
  CHECK_THROWS_AS(wireJson(std::string(100000, '[')), nlohmann::json::exception);
  CHECK_THROWS_AS(wireJson("{"), nlohmann::json::exception);
}
