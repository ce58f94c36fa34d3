#include "seal/Seal.hpp"

#include <catch2/catch.hpp>

namespace blind {

TEST_CASE("sealing hides the text and opening brings it back") {
  // Proves the round trip over several blocks; it is a seal against changing, not against reading.
  const std::string text(100, 'a');
  const std::string bytes = seal(text, "key");
  CHECK(bytes.find("aa") == bytes.npos);
  CHECK(unseal(bytes, "key") == text);
  CHECK(unseal(bytes, "other") != text);
}

} // namespace blind
