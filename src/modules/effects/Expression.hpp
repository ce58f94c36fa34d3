#pragma once

#include "effects/Effect.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace naocal {

/// Meaning of a name in a correction.
struct ExpressionSymbol {
  enum class Kind { own, elsewhere, time, com, imu, unknown } kind = Kind::own;
  Driver driver = Driver::angle;
  std::size_t index = 0; // elsewhere: joint; com and imu: 0 or 1; unknown: its index
};

/// Thrown for text that is not an expression, with description and position.
struct ExpressionError {
  std::string what;
  std::size_t letter = 0; // 0-based position in the text
};

/// A user-defined correction; parsed once per thread.
class Expression {
public:
  /// Resolves each name used in the text, in the order of names. Throws ExpressionError.
  Expression(const std::string& text, const std::function<ExpressionSymbol(const std::string&)>& resolve);

  const std::vector<ExpressionSymbol>& symbols() const { return names_; }

  /// Value of the correction [rad] at a joint.
  double operator()(const RobotSample& instant, std::size_t joint, std::span<const double> unknowns) const;

private:
  struct Parsed;
  Parsed& threadParser() const;

  std::string text_;
  std::shared_ptr<const char> identity_; // shared by copies: key of the per-thread parsers while a copy exists
  std::vector<std::string> texts_;       // names as written
  std::vector<ExpressionSymbol> names_;
};

} // namespace naocal
