#pragma once

#include "data/CaptureSetFile.hpp"
#include "io/InputError.hpp"

#include <string>

namespace naocal {

/// The sentence with which a text is refused as capture set.
inline std::string refusal(const std::string& text) {
  try {
    parseCaptureSet(text, "some/captures.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

} // namespace naocal
