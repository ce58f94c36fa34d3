#pragma once

#include "effects/Effect.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace naocal {

/// What a name in a correction stands for.
struct ExpressionSymbol {
  enum class Kind { own, elsewhere, time, com, imu, unknown } kind = Kind::own;
  Driver driver = Driver::angle;
  std::size_t index = 0; // the joint elsewhere; 0 or 1 of com and imu; which unknown
};

/// Thrown for text that is no expression; says what and where.
struct ExpressionError {
  std::string what;
  std::size_t letter = 0; // counted from 0
};

/// A correction as a person wrote it, parsed once per thread.
class Expression {
public:
  /// Resolves each name that the text uses, in the order of names. Throws ExpressionError.
  Expression(const std::string& text, const std::function<ExpressionSymbol(const std::string&)>& resolve);

  const std::vector<ExpressionSymbol>& symbols() const { return names_; }

  /// The value [rad] at a joint.
  double operator()(const RobotSample& instant, std::size_t joint, std::span<const double> unknowns) const;

private:
  struct Parsed;
  Parsed& threadParser() const;

  std::string text_;
  std::shared_ptr<const char> identity_; // the copies': a thread finds its own by it, as long as one lives
  std::vector<std::string> texts_;       // the names as written
  std::vector<ExpressionSymbol> names_;
};

} // namespace naocal
