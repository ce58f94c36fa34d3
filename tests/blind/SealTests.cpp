#include "seal/Seal.hpp"

#include <catch2/catch.hpp>

namespace blind {

TEST_CASE("sealing hides the text and opening brings it back") {
  // Proves the round trip over several blocks, and that another key does not restore the text. The seal makes
  // changes evident (tests/blind/CaseTests.cpp); it is not secret.
  const std::string text(100, 'a');
  const std::string bytes = seal(text, "key");
  CHECK(bytes.find("aa") == bytes.npos);
  CHECK(unseal(bytes, "key") == text);
  CHECK(unseal(bytes, "other") != text);
}

} // namespace blind
