#pragma once

#include "data/CaptureSetFile.hpp"
#include "io/InputError.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace naocal {

/// The message of the InputError for a capture set's text; "not refused" if there is none.
inline std::string refusal(const std::string& text) {
  try {
    parseCaptureSet(text, "some/captures.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

/// Checks that a refusal is one sentence that says where, expected and found, and holds the parts.
inline void checkSentence(const std::string& sentence, const std::vector<std::string>& parts) {
  CHECK(sentence.starts_with("some/captures.json: "));
  CHECK(sentence.find("expected ") != std::string::npos);
  CHECK(sentence.find("found ") != std::string::npos);
  CHECK(sentence.find('\n') == std::string::npos);
  for (const std::string& part : parts) {
    CHECK_THAT(sentence, Catch::Contains(part));
  }
}

} // namespace naocal
