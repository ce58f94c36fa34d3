#include "fuzz/driver/Mutation.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace naocal {
namespace {

using Random = std::mt19937_64;

constexpr std::array<std::string_view, 24> words{
    "null", "true", "-1", "0",        "1e999",   "-1e308",  "1e-320",  "NaN",      "2147483648", "18446744073709551616",
    "\"\"", "[]",   "{}", "[[[[[[[[", "{\"a\":", "\\u0000", "\\ud800", "\xff\xfe", "\xc0\x80",   "\n",
    "//",   "/*",   "%s", "../"};

/// Uniform below `end`; 0 if `end` is 0. Independent of the standard library's distributions.
std::size_t below(std::size_t end, Random& random) {
  return end == 0 ? 0 : static_cast<std::size_t>(random() % end);
}

void flipBit(std::string& text, Random& random) {
  if (!text.empty()) {
    text[below(text.size(), random)] ^= static_cast<char>(1 << below(8, random));
  }
}

void changeDigit(std::string& text, Random& random) {
  const std::size_t start = below(text.size(), random);
  const std::size_t digit = text.find_first_of("0123456789", start);
  if (digit != std::string::npos) {
    text[digit] = "0123456789-.e"[below(13, random)];
  }
}

void truncate(std::string& text, Random& random) {
  text.resize(below(text.size() + 1, random));
}

void removeStretch(std::string& text, Random& random) {
  const std::size_t start = below(text.size() + 1, random);
  text.erase(start, below(64, random));
}

void repeatStretch(std::string& text, Random& random) {
  const std::size_t start = below(text.size() + 1, random);
  const std::string stretch = text.substr(start, below(64, random));
  for (std::size_t times = 1 + below(8, random); times > 0; --times) {
    text.insert(start, stretch);
  }
}

void insertWord(std::string& text, Random& random) {
  const std::string_view word = words[below(words.size(), random)];
  text.insert(below(text.size() + 1, random), word);
}

/// Replaces a JSON value or a word: what lies between two separators.
void replaceValue(std::string& text, Random& random) {
  constexpr std::string_view separators = ":,[]{};= \n";
  const std::size_t found = text.find_first_of(separators, below(text.size() + 1, random));
  if (found != std::string::npos) {
    const std::size_t end = std::min(text.find_first_of(separators, found + 1), text.size());
    text.replace(found + 1, end - found - 1, words[below(words.size(), random)]);
  }
}

} // namespace

std::string mutate(const std::vector<std::string>& inputs, Random& random) {
  std::string text = inputs[below(inputs.size(), random)];
  constexpr std::array changes{flipBit,       flipBit,       changeDigit, changeDigit,  truncate,
                               removeStretch, repeatStretch, insertWord,  replaceValue, replaceValue};
  for (std::size_t times = 1 + below(4, random); times > 0; --times) {
    const std::size_t which = below(changes.size() + 1, random);
    if (which < changes.size()) {
      changes[which](text, random);
    } else { // splice
      const std::string& other = inputs[below(inputs.size(), random)];
      text = text.substr(0, below(text.size() + 1, random)) + other.substr(below(other.size() + 1, random));
    }
  }
  text.resize(std::min(text.size(), largestInput));
  return text;
}

} // namespace naocal
