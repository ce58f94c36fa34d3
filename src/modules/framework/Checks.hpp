#pragma once

#include <algorithm>
#include <string>
#include <vector>

/// What numbers may be asked to be (Parameter::Check): each says what it expects of a value that is not so.
namespace naocal {

/// A number from Low to High.
template <int Low, int High, class T> std::string within(const T& value) {
  const bool is = value >= Low && value <= High; // not so for what is no number
  return is ? "" : "a number from " + std::to_string(Low) + " to " + std::to_string(High);
}

/// Some numbers from Low to High, at most twenty.
template <int Low, int High> std::string eachWithin(const std::vector<double>& values) {
  const bool are =
      !values.empty() && values.size() <= 20 &&
      std::all_of(values.begin(), values.end(), [](double value) { return value >= Low && value <= High; });
  return are ? "" : "a list of one to twenty numbers from " + std::to_string(Low) + " to " + std::to_string(High);
}

/// Above none, at most the whole.
inline std::string share(const double& value) {
  return value > 0 && value <= 1 ? "" : "a number above 0, at most 1";
}

} // namespace naocal
