#pragma once

#include "io/InputError.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <utility>

namespace naocal {

/// Prints formatted text with control characters escaped: names in files must not reach a terminal as its commands.
template <class... Values>
void printText(std::FILE* stream, fmt::format_string<Values...> pattern, Values&&... values) {
  fmt::print(stream, "{}", printableText(fmt::format(pattern, std::forward<Values>(values)...)));
}
template <class... Values> void printText(fmt::format_string<Values...> pattern, Values&&... values) {
  printText(stdout, pattern, std::forward<Values>(values)...);
}

} // namespace naocal
