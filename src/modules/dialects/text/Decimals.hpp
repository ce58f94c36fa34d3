#pragma once

#include <string>

namespace naocal {

/// Digits behind the point in dialects' files, far below every standard error, so that what was printed is read and
/// printed again to the same digits.
namespace decimals {
inline constexpr int degree = 6; // 2e-8 rad
inline constexpr int radian = 9;
inline constexpr int metre = 9;
inline constexpr int share = 9; // of a picture's width or height; distortion
inline constexpr int pixel = 6;
inline constexpr int matrix = 12; // entries of a rotation
} // namespace decimals

/// The number rounded to some digits behind the point, without zeros at its end: "-2.27", "0".
std::string printDecimal(double number, int digits);

/// An angle [rad] with the digits of radians.
std::string printRadian(double angle);

/// The number as `printDecimal` prints it: a JSON writer prints no more digits of it.
double roundDecimal(double number, int digits);

} // namespace naocal
