#include "dialects/text/Decimals.hpp"

#include <charconv>
#include <fmt/format.h>

namespace naocal {

std::string printDecimal(double number, int digits) {
  std::string text = fmt::format("{:.{}f}", number, digits);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    text.erase(text.find_last_not_of('.') + 1);
  }
  return text == "-0" ? "0" : text;
}

std::string printRadian(double angle) {
  return printDecimal(angle, decimals::radian);
}

double roundDecimal(double number, int digits) {
  const std::string text = printDecimal(number, digits);
  double rounded = number; // infinity and NaN stay
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

} // namespace naocal
