#include "io/XmlDocument.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <sstream>

namespace naocal {

namespace {

/// Position behind the next `mark` from `begin` on.
std::size_t behind(std::string_view text, std::string_view mark, std::size_t begin) {
  const std::size_t at = text.find(mark, begin);
  return at == text.npos ? text.size() : at + mark.size();
}

/// Position behind the tag from `begin` on; a > within a quoted value does not end it.
std::size_t behindTag(std::string_view text, std::size_t begin) {
  char quote = 0;
  for (std::size_t at = begin; at < text.size(); ++at) {
    const char letter = text[at];
    if (quote != 0) {
      quote = letter == quote ? 0 : quote;
    } else if (letter == '>') {
      return at + 1;
    } else if (letter == '"' || letter == '\'') {
      quote = letter;
    }
  }
  return text.size();
}

/// Whether TinyXML takes what follows a < for the name of an element.
bool beginsName(std::string_view text) {
  return !text.empty() && (text[0] == '_' || std::isalpha(static_cast<unsigned char>(text[0])) != 0 ||
                           static_cast<unsigned char>(text[0]) >= 127);
}

/// The most elements within each other, as TinyXML would see them.
int depthOf(std::string_view text) {
  int level = 0, most = 0;
  for (std::size_t at = text.find('<'); at != text.npos; at = text.find('<', at)) {
    const std::string_view rest = text.substr(at + 1);
    if (rest.starts_with("!--")) {
      at = behind(text, "-->", at + 4);
    } else if (rest.starts_with("![CDATA[")) {
      at = behind(text, "]]>", at);
    } else if (rest.starts_with("/")) {
      level = std::max(level - 1, 0);
      ++at;
    } else if (!beginsName(rest)) { // a declaration or what TinyXML does not know
      at = behind(text, ">", at);
    } else {
      at = behindTag(text, at);
      most = std::max(most, level + 1);
      level += text.substr(0, at).ends_with("/>") ? 0 : 1;
    }
  }
  return most;
}

} // namespace

TiXmlDocument parseXml(const std::string& text, const std::string& file, const std::string& kind) {
  constexpr int most = 100; // a URDF's deepest element is the fourth
  if (text.find('\0') != text.npos) {
    throw InputError{fmt::format("{}: expected {}, found a zero byte", file, kind)};
  }
  if (depthOf(text) > most) {
    throw InputError{fmt::format("{}: expected {}, found more than {} elements within each other", file, kind, most)};
  }
  TiXmlDocument document;
  document.Parse(text.c_str()); // as urdfdom does: other options read &#228; otherwise
  if (document.Error()) {
    throw InputError{fmt::format("{}, line {}, column {}: expected XML, found an error there ({})", file,
                                 document.ErrorRow(), document.ErrorCol(), document.ErrorDesc())};
  }
  return document;
}

std::optional<std::vector<double>> parseXmlNumbers(std::string_view text) {
  std::vector<double> numbers;
  std::istringstream words{std::string{text}};
  for (std::string word; words >> word;) {
    const std::string_view digits = word.starts_with('+') ? std::string_view{word}.substr(1) : word;
    double number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(number)) {
      return std::nullopt;
    }
    numbers.push_back(number);
  }
  return numbers;
}

} // namespace naocal
