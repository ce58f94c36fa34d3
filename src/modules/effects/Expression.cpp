#include "effects/Expression.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <muParser.h>
#include <string_view>

namespace naocal {

namespace {

double valueOf(const ExpressionSymbol& name, const RobotSample& instant, std::size_t joint,
               std::span<const double> unknowns) {
  const auto at = static_cast<Eigen::Index>(name.kind == ExpressionSymbol::Kind::own ? joint : name.index);
  switch (name.kind) {
  case ExpressionSymbol::Kind::time:
    return instant.time.count();
  case ExpressionSymbol::Kind::com:
    return instant.com[at];
  case ExpressionSymbol::Kind::imu:
    return instant.imu[at];
  case ExpressionSymbol::Kind::unknown:
    return unknowns[name.index];
  case ExpressionSymbol::Kind::own:
  case ExpressionSymbol::Kind::elsewhere:
    break;
  }
  switch (name.driver) {
  case Driver::torque:
    return instant.torque[at];
  case Driver::velocity:
    return instant.velocity[at];
  case Driver::approach:
    return instant.approach[at];
  case Driver::temperature:
    return instant.temperature[at];
  case Driver::current:
    return instant.current[at];
  default:
    return instant.q[at];
  }
}

/// Position of the name that ends before `end`; `end` if none does.
std::size_t beginOfName(const std::string& text, std::size_t end) {
  std::size_t begin = end;
  while (begin > 0 && (std::isalnum(static_cast<unsigned char>(text[begin - 1])) != 0 || text[begin - 1] == '_')) {
    --begin;
  }
  return begin;
}

/// Error for a name before a parenthesis that is no function.
ExpressionError refuseFunction(const std::string& name, std::size_t letter) {
  const mu::Parser parser;
  std::vector<std::string> functions;
  for (const auto& [function, callback] : parser.GetFunDef()) {
    functions.push_back(function);
  }
  return {fmt::format("\"{}\" is no function; near it are {} (at letter {})", name,
                      fmt::join(closestNames(name, functions), ", "), letter + 1),
          letter};
}

ExpressionError translateError(const mu::Parser::exception_type& error, const std::string& text) {
  const auto letter = static_cast<std::size_t>(std::clamp<int>(error.GetPos(), 0, static_cast<int>(text.size())));
  if (error.GetCode() == mu::ecUNEXPECTED_PARENS && letter < text.size() && text[letter] == '(') {
    if (const std::size_t begin = beginOfName(text, letter); begin < letter) {
      return refuseFunction(text.substr(begin, letter - begin), begin);
    }
  }
  return {fmt::format("{} (at letter {})", error.GetMsg(), letter + 1), letter};
}

/// Position of an assignment ("=" that is part of no comparison), which would change a value for the rest of the text.
std::size_t findAssignment(const std::string& text) {
  for (std::size_t at = text.find('='); at != std::string::npos; at = text.find('=', at + 1)) {
    const bool endsComparison = at > 0 && std::string_view{"=<>!"}.find(text[at - 1]) != std::string_view::npos;
    const bool beginsComparison = at + 1 < text.size() && text[at + 1] == '=';
    if (!endsComparison && !beginsComparison) {
      return at;
    }
  }
  return std::string::npos;
}

/// Position of the first comma outside parentheses, which separates values.
std::size_t findSeparator(const std::string& text) {
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    depth += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
    if (text[at] == ',' && depth == 0) {
      return at;
    }
  }
  return std::string::npos;
}

/// Throws ExpressionError for what muParser accepts beyond one value: several of them, of which it takes the last, and
/// assignments.
void requireOneValue(const std::string& text) {
  if (const std::size_t at = findAssignment(text); at != std::string::npos) {
    throw ExpressionError{fmt::format("= assigns a value; compare with == (at letter {})", at + 1), at};
  }
  if (const std::size_t at = findSeparator(text); at != std::string::npos) {
    throw ExpressionError{fmt::format("several values, separated by a comma; add them (at letter {})", at + 1), at};
  }
}

} // namespace

/// Parser of one thread, since evaluation by muParser is not thread-safe.
struct Expression::Parsed {
  mu::Parser parser;
  std::vector<double> values; // values of the names
  std::weak_ptr<const char> identity;
};

Expression::Expression(const std::string& text, const std::function<ExpressionSymbol(const std::string&)>& resolve)
    : text_{text}, identity_{std::make_shared<const char>()} {
  requireOneValue(text);
  try {
    mu::Parser parser;
    parser.SetExpr(text);
    for (const auto& [name, variable] : parser.GetUsedVar()) {
      texts_.push_back(name);
    }
  } catch (const mu::Parser::exception_type& error) {
    throw translateError(error, text);
  }
  for (const std::string& name : texts_) {
    names_.push_back(resolve(name));
  }
  try {
    threadParser().parser.Eval();
  } catch (const mu::Parser::exception_type& error) {
    throw translateError(error, text);
  }
}

Expression::Parsed& Expression::threadParser() const {
  static thread_local std::map<const char*, Parsed> all;
  const auto [entry, isNew] = all.try_emplace(identity_.get());
  Parsed& parsed = entry->second;
  if (isNew || parsed.identity.expired()) {
    parsed = {};
    parsed.identity = identity_;
    std::erase_if(all, [](const auto& one) { return one.second.identity.expired(); });
    parsed.values.assign(texts_.size(), 0);
    for (std::size_t i = 0; i < texts_.size(); ++i) {
      parsed.parser.DefineVar(texts_[i], &parsed.values[i]);
    }
    parsed.parser.SetExpr(text_);
  }
  return parsed;
}

double Expression::operator()(const RobotSample& instant, std::size_t joint, std::span<const double> unknowns) const {
  Parsed& parsed = threadParser();
  for (std::size_t i = 0; i < names_.size(); ++i) {
    parsed.values[i] = valueOf(names_[i], instant, joint, unknowns);
  }
  return parsed.parser.Eval();
}

} // namespace naocal
