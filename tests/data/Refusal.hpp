#pragma once

#include "data/CaptureSetFile.hpp"
#include "io/InputError.hpp"

#include <string>

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

} // namespace naocal
