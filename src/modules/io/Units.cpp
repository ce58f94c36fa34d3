#include "io/Units.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <regex>

namespace naocal {

std::optional<UnitPowers> parseUnit(std::string_view text) {
  static const std::regex factor{R"(([*/]?)(1|rad|m|px|s|row|Nm|K|A)(?:\^(\d+(?:\.\d+)?))?(?=[*/]|$))"};
  const std::string all{text};
  UnitPowers unit;
  std::size_t read = 0;
  for (std::sregex_iterator found{all.begin(), all.end(), factor, std::regex_constants::match_continuous}, end;
       found != end; ++found) {
    const std::string sign = (*found)[1], base = (*found)[2], power = (*found)[3];
    if (sign.empty() != (read == 0)) {
      break;
    }
    read += static_cast<std::size_t>(found->length());
    if (base != "1") {
      unit =
          multiplyUnits(std::move(unit), {{base, 1}}, (sign == "/" ? -1 : 1) * (power.empty() ? 1 : std::stod(power)));
    }
  }
  return read > 0 && read == all.size() ? std::optional{unit} : std::nullopt;
}

std::string formatUnit(const UnitPowers& unit) {
  std::string over, under;
  for (const auto& [base, power] : unit) {
    std::string& side = power > 0 ? over : under;
    const double size = std::abs(power);
    side += fmt::format("{}{}{}",
                        power < 0      ? "/"
                        : side.empty() ? ""
                                       : "*",
                        base, size == 1 ? "" : fmt::format("^{:g}", size));
  }
  return (over.empty() ? "1" : over) + under;
}

UnitPowers multiplyUnits(UnitPowers one, const UnitPowers& other, double power) {
  for (const auto& [base, own] : other) {
    const double sum = one[base] + own * power;
    if (sum == 0) {
      one.erase(base);
    } else {
      one[base] = sum;
    }
  }
  return one;
}

int decimalsFor(double sigma) {
  constexpr double most = 9;
  const double size = std::abs(sigma);
  return size > 0 && std::isfinite(size) ? static_cast<int>(std::clamp(1 - std::floor(std::log10(size)), 0.0, most))
                                         : 0;
}

std::string formatSize(double size, const std::string& unit) {
  const auto [shown, scale] = displayUnit(unit);
  std::string number = fmt::format("{:.{}f}", scale * size, decimalsFor(scale * size));
  if (number.find('.') != number.npos) { // no zeros at the end
    number.erase(number.find_last_not_of('0') + 1);
    number.erase(number.find_last_not_of('.') + 1);
  }
  return appendUnit(std::move(number), shown);
}

std::string formatEstimate(double value, double sigma) {
  const int decimals = decimalsFor(sigma);
  const bool isZero = std::abs(value) < std::pow(10.0, -decimals) / 2; // no "-0.00"
  return fmt::format("{:.{}f} ± {:.{}f}", isZero ? 0 : value, decimals, sigma, decimals);
}

} // namespace naocal
