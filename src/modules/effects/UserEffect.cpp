#include "effects/UserEffect.hpp"

#include "effects/Catalogue.hpp"
#include "effects/Expression.hpp"
#include "io/InputError.hpp"
#include "io/Units.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Names = std::map<std::string, ExpressionSymbol>;

/// All names that a correction may use, except its unknowns.
Names namesOf(const Robot& robot) {
  using Kind = ExpressionSymbol::Kind;
  Names names{{"q", {Kind::own, Driver::angle}},       {"tau", {Kind::own, Driver::torque}},
              {"qd", {Kind::own, Driver::velocity}},   {"approach", {Kind::own, Driver::approach}},
              {"T", {Kind::own, Driver::temperature}}, {"current", {Kind::own, Driver::current}},
              {"t", {Kind::time, Driver::time}},       {"com_x", {Kind::com, Driver::com, 0}},
              {"com_y", {Kind::com, Driver::com, 1}},  {"imu_x", {Kind::imu, Driver::imu, 0}},
              {"imu_y", {Kind::imu, Driver::imu, 1}}};
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    names[robot.joints[joint].name] = {Kind::elsewhere, Driver::angle, joint};
    names["tau_" + robot.joints[joint].name] = {Kind::elsewhere, Driver::torque, joint};
  }
  return names;
}

std::vector<std::string> listNames(const Names& names) {
  std::vector<std::string> result;
  for (const auto& [name, meaning] : names) {
    result.push_back(name);
  }
  return result;
}

/// Requires a valid name in expressions, on the command line and in files: letters, digits and '_', not starting with a
/// digit.
void requireName(const JsonCursor& place, const std::string& name) {
  const auto good = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  if (name.empty() || !std::all_of(name.begin(), name.end(), good) ||
      std::isdigit(static_cast<unsigned char>(name[0])) != 0) {
    place.refuse("a name of letters, digits and _", '"' + name + '"');
  }
}

std::vector<Unknown> readUnknowns(const JsonCursor& place, Names& names) {
  std::vector<Unknown> unknowns;
  for (const auto& [name, unknown] : place.members()) {
    requireName(unknown, name);
    if (names.contains(name)) {
      unknown.refuse("a name of its own", fmt::format("\"{}\", which already stands for something else", name));
    }
    names[name] = {ExpressionSymbol::Kind::unknown, Driver::angle, unknowns.size()};
    const JsonCursor unit = unknown.at("unit");
    if (!parseUnit(unit.text())) {
      unit.refuse(fmt::format("\"1\" or a product of powers of {}, such as rad/Nm^2", unitBases));
    }
    unknowns.push_back({name, unit.text(), unknown.at("sigma").number({1e-12, 1e6, "of the unknown's unit, above 0"})});
  }
  if (unknowns.empty()) {
    place.refuse("at least one unknown");
  }
  return unknowns;
}

/// Refuses the text at a position.
[[noreturn]] void refuseAt(std::size_t letter, const JsonCursor& place, std::string_view expected,
                           const std::string& found) {
  try {
    place.refuse(expected, found);
  } catch (const InputError& refusal) {
    throw CorrectionError{refusal.what(), letter};
  }
}

/// Position of the first occurrence of a name as a whole word.
std::size_t placeOf(const std::string& name, const std::string& text) {
  const auto inName = [&](std::size_t i) {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_');
  };
  std::size_t at = text.find(name);
  while (at != std::string::npos && ((at > 0 && inName(at - 1)) || inName(at + name.size()))) {
    at = text.find(name, at + 1);
  }
  return at == std::string::npos ? 0 : at;
}

Expression expressionOf(const JsonCursor& place, const Names& names) {
  const std::string text = place.text();
  try {
    return {text, [&](const std::string& name) {
              const auto known = names.find(name);
              if (known == names.end()) {
                refuseAt(
                    placeOf(name, text), place, "names that are known",
                    fmt::format("'{}'; near it are {}", name, fmt::join(closestNames(name, listNames(names)), ", ")));
              }
              return known->second;
            }};
  } catch (const ExpressionError& error) {
    refuseAt(error.letter, place, "an expression such as \"a*sin(3*q) + b*abs(tau)\"",
             fmt::format("\"{}\": {}", text, error.what));
  }
}

/// Requires that the correction is zero where all unknowns are zero.
void requireNothingAtZero(const JsonCursor& place, const Expression& expression, const Effect& effect,
                          const Robot& robot) {
  RobotSample instant;
  instant.time = Seconds{10};
  instant.q = Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(robot.joints.size()), 0.2, 0.4);
  instant.velocity = instant.approach = instant.temperature = instant.current = instant.torque = instant.q;
  instant.com = instant.imu = {0.02, 0.03};
  const double value = expression(instant, 0, std::vector<double>(effect.unknowns.size(), 0));
  if (!(std::abs(value) < 1e-12)) {
    place.refuse("an expression that is 0 where its unknowns are 0", fmt::format("{:.3g} rad there", value));
  }
}

} // namespace

Effect parseUserEffect(const JsonCursor& definition, const Robot& robot) {
  Names names = namesOf(robot);
  Effect effect{.name = definition.at("name").text(), .placeKind = PlaceKind::motor, .linear = false, .kink = true};
  requireName(definition.at("name"), effect.name);
  const JsonCursor at = definition.at("at");
  if (at.text() != "*") {
    const auto joint = robot.jointIndex(at.text());
    if (!joint) {
      std::vector<std::string> joints;
      for (const Joint& each : robot.joints) {
        joints.push_back(each.name);
      }
      at.refuse("a joint or \"*\"",
                fmt::format("\"{}\"; near it are {}", at.text(), fmt::join(closestNames(at.text(), joints), ", ")));
    }
    effect.onlyAtMotor = robot.joints[*joint].motor;
  }
  effect.unknowns = readUnknowns(definition.at("unknowns"), names);
  const JsonCursor correction = definition.at("correction");
  const Expression expression = expressionOf(correction, names);
  requireNothingAtZero(correction, expression, effect, robot);
  for (const ExpressionSymbol& name : expression.symbols()) {
    if (name.kind == ExpressionSymbol::Kind::elsewhere) {
      effect.remoteDrivers.push_back({name.driver, name.index});
    } else if (name.kind != ExpressionSymbol::Kind::unknown) {
      effect.drivers.push_back(name.driver);
    }
  }
  std::sort(effect.drivers.begin(), effect.drivers.end()); // com_x and com_y share one driver
  effect.drivers.erase(std::unique(effect.drivers.begin(), effect.drivers.end()), effect.drivers.end());
  const auto what = definition.find("what");
  effect.description = what ? what->text() : "an effect of your own";
  effect.formula = "+" + correction.text();
  effect.definition = definition.value().dump();
  effect.correct = [expression](ModelState& modelState, const RobotSample& instant, std::size_t joint,
                                std::span<const double> values) {
    modelState.angle(joint) += expression(instant, joint, values);
  };
  return effect;
}

std::vector<Effect> parseUserEffects(const JsonCursor& definitions, const Robot& robot) {
  std::vector<Effect> result;
  for (const JsonCursor& definition : definitions.elements()) {
    result.push_back(parseUserEffect(definition, robot));
    const std::string& name = result.back().name;
    const auto same = [&](const Effect& other) { return other.name == name || other.alias == name; };
    if (std::any_of(allEffects().begin(), allEffects().end(), same) ||
        std::any_of(result.begin(), result.end() - 1, same)) {
      definition.at("name").refuse("a name that no other effect has", '"' + name + '"');
    }
  }
  return result;
}

} // namespace naocal
