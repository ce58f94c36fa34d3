#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// Invalid external input (a file, an option): one sentence with location, expected and found. Caught in `main`, which
/// prints it and exits with code 2.
class InputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// The text for a terminal or a log: control characters (ASCII, and those of UTF-8 in two bytes) become \xNN, except
/// line feeds and tabs. Longer texts than `longest` bytes are cut and end with "...".
std::string printableText(std::string_view text, std::size_t longest = std::string_view::npos);

inline constexpr std::size_t longestSentence = 2000; // [bytes] of an error's sentence on a terminal

inline constexpr std::size_t longestComparedName = 64; // letters that `closestNames` compares

/// Known names with the smallest edit distance to `text`, best first, as suggestions for misspelt names;
/// compares their first letters only.
std::vector<std::string> closestNames(const std::string& text, const std::vector<std::string>& known,
                                      std::size_t most = 5);

} // namespace naocal
