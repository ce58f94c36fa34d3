#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// Columns of the terminal on standard output, from 50 to 110; 80 where it is none.
std::size_t terminalWidth();

/// Columns that a UTF-8 text takes, one per code point.
std::size_t columnsOf(std::string_view text);

/// A table row: `head` indented by two columns, `text` wrapped from column `start` on; below the head if that is long.
std::string layOutRow(std::string_view head, std::string_view text, std::size_t start, std::size_t width);

/// The text wrapped at `width`; further lines of a paragraph are indented by `hanging` columns more than its first.
std::string wrapText(std::string_view text, std::size_t width, std::size_t hanging = 0);

/// "left, right or both".
std::string joinWords(const std::vector<std::string>& words, std::string_view last);

} // namespace naocal
