#include "command-line/TextLayout.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace naocal {

namespace {

/// The words of a line, broken where `width` is exceeded. The first line begins at column `first` and the others at
/// column `start`.
std::string wrapLine(std::string_view line, std::size_t first, std::size_t start, std::size_t width) {
  std::string result;
  std::size_t column = first;
  bool isFirst = true;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t end = std::min(line.find(' ', at), line.size());
    const std::string_view word = line.substr(at, end - at);
    at = end + 1;
    if (!isFirst && column + 1 + columnsOf(word) > width) {
      result += "\n" + std::string(start, ' ');
      column = start;
    } else if (!isFirst) {
      result += ' ';
      ++column;
    }
    result += word;
    column += columnsOf(word);
    isFirst = false;
  }
  return result;
}

} // namespace

std::size_t terminalWidth() {
  winsize size{};
  constexpr std::size_t usual = 80;
  if (isatty(STDOUT_FILENO) == 0 || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) {
    return usual;
  }
  return std::clamp<std::size_t>(size.ws_col, 50, 110);
}

std::size_t columnsOf(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

std::string layOutRow(std::string_view head, std::string_view text, std::size_t start, std::size_t width) {
  const std::size_t used = 2 + columnsOf(head);
  std::string row = "  " + std::string{head};
  if (text.empty()) {
    return row + "\n";
  }
  row += used + 2 > start ? "\n" + std::string(start, ' ') : std::string(start - used, ' ');
  return row + wrapLine(text, start, start, width) + "\n";
}

std::string wrapText(std::string_view text, std::size_t width, std::size_t hanging) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    result += std::string(indent, ' ') + wrapLine(line.substr(indent), indent, indent + hanging, width) + "\n";
  }
  return result;
}

std::string joinWords(const std::vector<std::string>& words, std::string_view last) {
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i) {
    result += i == 0 ? "" : i + 1 == words.size() ? fmt::format(" {} ", last) : std::string{", "};
    result += words[i];
  }
  return result;
}

} // namespace naocal
