#include "diagnose/TellingSentences.hpp"

#include "io/Units.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

using Error = TellingPair::Error;
using Over = TellingPair::Over;

std::string errorWords(const TellingPair& pair, const Robot& robot) {
  switch (pair.error) {
  case Error::right:
    return "errors to the right";
  case Error::down:
    return "errors down";
  case Error::joint:
    break;
  }
  return fmt::format("{}'s error that would explain the misfit", robot.joints[pair.motor].name);
}

const DriverValues* driverOf(const TellingPair& pair, const std::vector<DriverValues>& drivers) {
  return pair.over == Over::driver ? &drivers[pair.driver] : nullptr;
}

/// What the error is drawn over.
std::string overWords(const TellingPair& pair, const std::vector<DriverValues>& drivers, const Robot& robot) {
  const DriverValues* const driver = driverOf(pair, drivers);
  return driver != nullptr           ? drivenBy(*driver, robot)
         : pair.over == Over::column ? "the column in the picture"
                                     : "the row in the picture";
}

/// "6.0 px", "-0.41°"; two digits.
std::string amount(const TellingPair& pair, double value) {
  const double shown = pair.error == Error::joint ? degrees(value) : value;
  const double size = std::abs(shown);
  const int digits = size < 0.0995 ? 3 : size < 0.995 ? 2 : size < 9.95 ? 1 : 0;
  return (shown < 0 ? "−" : "") +
         withUnit(fmt::format("{:.{}f}", size, digits), pair.error == Error::joint ? "°" : "px");
}

/// "go from A to B as the torque on LHipPitch grows"
std::string change(const TellingPair& pair, const std::vector<DriverValues>& drivers, const Robot& robot) {
  const bool one = pair.error == Error::joint; // singular
  const std::string over = overWords(pair, drivers, robot), from = amount(pair, pair.from), to = amount(pair, pair.to);
  const DriverValues* const driver = driverOf(pair, drivers);
  if (driver != nullptr && driver->kind == Driver::approach) {
    return fmt::format("{} {} where {} was approached from below and {} where from above", one ? "is" : "are", to,
                       robot.joints[driver->joint].name, from); // the last motion was upwards where it is +1
  }
  if (pair.hasTwoValues) {
    return fmt::format("{} {} at the smaller and {} at the larger of two values of {}", one ? "is" : "are", from, to,
                       over);
  }
  constexpr double monotone = 0.8; // of what the curve spans lies between its ends
  if (std::abs(pair.to - pair.from) < monotone * (pair.most - pair.least)) {
    return fmt::format("{} between {} and {} with {}", one ? "varies" : "vary", amount(pair, pair.least),
                       amount(pair, pair.most), over);
  }
  const std::string go = one ? "goes" : "go";
  if (driver == nullptr) {
    const bool column = pair.over == Over::column;
    return fmt::format("{} from {} at the {} of the picture to {} at its {}", go, from, column ? "left" : "top", to,
                       column ? "right" : "bottom");
  }
  return driver->kind == Driver::time ? fmt::format("{} from {} to {} over time", go, from, to)
                                      : fmt::format("{} from {} to {} as {} grows", go, from, to, over);
}

} // namespace

std::string drivenBy(const DriverValues& driver, const Robot& robot) {
  const std::string& joint = robot.joints[driver.joint].name;
  switch (driver.kind) {
  case Driver::approach:
    return fmt::format("the direction from which {} was approached", joint);
  case Driver::temperature:
    return fmt::format("the temperature of {}", joint);
  case Driver::velocity:
    return fmt::format("the speed of {}", joint);
  default:
    return driver.what;
  }
}

std::string tellingLabel(const TellingPair& pair, const std::vector<DriverValues>& drivers, const Robot& robot) {
  const std::string error =
      pair.error == Error::joint ? fmt::format("error of {}", robot.joints[pair.motor].name) : errorWords(pair, robot);
  return fmt::format("{} over {}", error, overWords(pair, drivers, robot));
}

std::string tellingSentence(const TellingPair& pair, const std::vector<DriverValues>& drivers, const Robot& robot) {
  const double small = std::min(std::abs(pair.from), std::abs(pair.to)),
               large = std::max(std::abs(pair.from), std::abs(pair.to));
  const DriverValues* const driver = driverOf(pair, drivers);
  // the smaller side of an error against the larger: beyond the first it turns round, beyond the second "±" says it
  constexpr double turned = 0.3, even = 0.7;
  const bool turns =
      driver != nullptr && driver->kind == Driver::approach && pair.from * pair.to < 0 && small > turned * large;
  std::string text = errorWords(pair, robot);
  if (turns) {
    const std::string size = small > even * large ? "±" + amount(pair, (small + large) / 2)
                                                  : fmt::format("{} from below, {} from above", amount(pair, pair.to),
                                                                amount(pair, pair.from));
    text += fmt::format(" ({}) {} sign with {}", size, pair.error == Error::joint ? "changes" : "change",
                        overWords(pair, drivers, robot));
  } else {
    text += " " + change(pair, drivers, robot);
  }
  text[0] = static_cast<char>(std::toupper(text[0]));
  const double percent = 100 * std::min(1.0, pair.share);
  return text + (percent < 1 ? ". That is less than 1 % of the squared error."
                             : fmt::format(". That is {:.0f} % of the squared error.", percent));
}

std::string tellingSentence(const TellingPairs& telling, const std::vector<DriverValues>& drivers, const Robot& robot) {
  if (!telling.pairs.empty()) {
    return tellingSentence(telling.pairs.front(), drivers, robot);
  }
  return telling.tried == 0
             ? "Too few poses to tell a trend from chance."
             : fmt::format("No trend beyond chance: none of {} pairs of an error and what may drive it stands out.",
                           telling.tried);
}

} // namespace naocal
