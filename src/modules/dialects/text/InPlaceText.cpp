#include "dialects/text/InPlaceText.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace naocal {

namespace {

/// The text with blanks for its comments, and every other byte where it was.
std::string blankComments(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"' || text[i] == '\'') {
      const char quote = text[i];
      for (++i; i < text.size() && text[i] != quote; ++i) {
        i += text[i] == '\\' ? 1 : 0;
      }
    } else if (text.compare(i, 2, "//") == 0 || text.compare(i, 2, "/*") == 0) {
      const bool isLine = text[i + 1] == '/';
      const std::size_t found = isLine ? text.find('\n', i) : text.find("*/", i + 2);
      const std::size_t end = std::min(found == std::string::npos ? found : found + (isLine ? 0 : 2), text.size());
      std::replace_if(
          text.begin() + static_cast<std::ptrdiff_t>(i), text.begin() + static_cast<std::ptrdiff_t>(end),
          [](char letter) { return letter != '\n'; }, ' ');
      i = end - 1;
    }
  }
  return text;
}

} // namespace

InPlaceText::InPlaceText(std::string text, const std::string& file, InPlaceSyntax syntax)
    : text_{std::move(text)}, top_{syntax == InPlaceSyntax::json5 ? blankComments(text_) : text_, file} {}

void InPlaceText::replace(const YamlCursor& value, const std::string& written) {
  const std::string before = value.text();
  std::size_t start = value.position();
  start += start < text_.size() && (text_[start] == '"' || text_[start] == '\'') ? 1 : 0;
  if (before.empty() || start >= text_.size() || text_.compare(start, before.size(), before) != 0) {
    value.refuse("a value on one line, without escapes", "another");
  }
  replacements_.insert_or_assign(start, Replacement{before.size(), written});
}

void InPlaceText::replace(const std::vector<YamlCursor>& values, const Eigen::Vector3d& numbers,
                          std::string (*print)(double)) {
  assert(values.size() == 3);
  for (std::size_t i = 0; i < values.size(); ++i) {
    replace(values[i], print(numbers[static_cast<Eigen::Index>(i)]));
  }
}

std::string InPlaceText::edited() const {
  std::string text = text_;
  for (auto one = replacements_.rbegin(); one != replacements_.rend(); ++one) {
    text.replace(one->first, one->second.length, one->second.written);
  }
  return text;
}

} // namespace naocal
