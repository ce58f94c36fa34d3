#include "diagnosis/views/TellingPairs.hpp"

#include "diagnosis/views/Trend.hpp"
#include "io/Units.hpp"
#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <tuple>

namespace naocal {

namespace {

using Error = TellingPair::Error;
using Over = TellingPair::Over;

/// A value with its pictures. Subtracting t from it lowers the squared errors by 2 slope t - gram t^2 [px^2].
struct Value {
  std::vector<std::size_t> pictures;
  std::size_t block = 0; // block of poses
  double y = 0, weight = 1;
  double slope = 0, gram = 0;
  double column = 0, row = 0; // position of a corner [px]
};

std::vector<std::size_t> blocksOfPictures(const Measurements& measurements) {
  std::vector<std::size_t> result = posesOfPictures(measurements);
  for (std::size_t& block : result) {
    block = Trend::blockOf(block, measurements.poses.size());
  }
  return result;
}

/// Predicted - measured of every corner with a weight, at joint angles as read.
std::vector<Value> cornerErrors(const CalibrationResult& fit, const std::vector<std::size_t>& blocks, Error error) {
  const Eigen::Index axis = error == Error::right ? 0 : 1;
  std::vector<Value> result;
  for (std::size_t i = 0; i < fit.withReportedAngles.size(); ++i) {
    const BoardResidual& seen = fit.withReportedAngles[i];
    for (Eigen::Index corner = 0; corner < seen.residual.cols(); ++corner) {
      const double weight = fit.residuals[i].weight[corner]; // with deflections: only outliers lose weight
      const double y = -seen.residual(axis, corner);
      if (weight > 0 && std::isfinite(y)) {
        const Eigen::Vector2d place = seen.predicted.col(corner) + seen.residual.col(corner);
        result.push_back({{seen.picture}, blocks[seen.picture], y, weight, weight * y, weight, place.x(), place.y()});
      }
    }
  }
  return result;
}

/// Averages the corners of each picture, since external drivers are the same for all of them.
std::vector<Value> averageByPicture(const std::vector<Value>& corners, std::size_t pictures) {
  std::vector<Value> sums(pictures);
  for (const Value& corner : corners) {
    Value& sum = sums[corner.pictures.front()];
    sum.pictures = corner.pictures;
    sum.block = corner.block;
    sum.slope += corner.slope;
    sum.gram += corner.gram;
  }
  std::erase_if(sums, [](const Value& sum) { return sum.pictures.empty(); });
  for (Value& sum : sums) {
    sum.y = sum.slope / sum.gram;
    sum.weight = sum.gram;
  }
  return sums;
}

std::vector<Value> jointErrors(const SingleJointCorrection& joint, const std::vector<std::size_t>& blocks) {
  std::vector<Value> result;
  for (const JointCorrection& point : joint.points) {
    result.push_back({point.pictures, blocks[point.pictures.front()], point.deflection, 1 / (point.sigma * point.sigma),
                      -point.gradient, point.gram});
  }
  return result;
}

/// All errors to be plotted.
struct PlottableErrors {
  std::vector<Value> right, down;                   // per corner
  std::vector<Value> rightByPicture, downByPicture; // means over each picture's corners
  std::vector<std::vector<Value>> joints;           // per joint

  /// Sum of the squared corner errors [px^2].
  double squares() const {
    double result = 0;
    for (const std::vector<Value>* corners : {&right, &down}) {
      for (const Value& corner : *corners) {
        result += corner.weight * corner.y * corner.y;
      }
    }
    return result;
  }
};

/// Sum of the squared errors of readings that are no corners, on the scale of pixels: an error of as many sigmas.
double readingSquares(const FittedModel& fitted) {
  const Measurements& measurements = fitted.measurements;
  const Noise& noise = fitted.fit.noise;
  if (measurements.witnessCount == 0) {
    return 0;
  }
  double result = 0;
  const Residuals residuals{measurements, fitted.model, noise, fitted.fit.loss};
  for (const WitnessResidual& one : residuals.witnessResiduals(fitted.fit.state)) {
    for (const Witness::Part& part : measurements.pictures[one.picture].witnesses[one.witness].witness->parts()) {
      const double scale = noise.pixel / sigmaOf(measurements, noise, part.level);
      result += scale * scale * one.residual.segment(part.first, part.count).squaredNorm();
    }
  }
  return result;
}

PlottableErrors collectErrors(const FittedModel& fitted, const std::vector<SingleJointCorrection>& joints) {
  const std::vector<std::size_t> blocks = blocksOfPictures(fitted.measurements);
  PlottableErrors result;
  result.right = cornerErrors(fitted.fit, blocks, Error::right);
  result.down = cornerErrors(fitted.fit, blocks, Error::down);
  result.rightByPicture = averageByPicture(result.right, blocks.size());
  result.downByPicture = averageByPicture(result.down, blocks.size());
  for (const SingleJointCorrection& joint : joints) {
    result.joints.push_back(jointErrors(joint, blocks));
  }
  return result;
}

/// A pair under test.
struct Tried {
  TellingPair pair;
  const std::vector<Value>* values = nullptr;
  std::vector<double> x; // per value
};

Tried tryPair(TellingPair pair, const std::vector<Value>& values, const std::vector<DriverSeries>& drivers) {
  Tried result{pair, &values, {}};
  for (const Value& value : values) {
    result.x.push_back(pair.over == Over::column ? value.column
                       : pair.over == Over::row  ? value.row
                                                 : drivers[pair.driver].mean(value.pictures));
  }
  return result;
}

/// Every error with everything that may drive it: corners over their position, means over pictures over all drivers,
/// joints over their own drivers and those of no particular joint. `joints`: as in `errors`.
std::vector<Tried> tryAllPairs(const PlottableErrors& errors, const std::vector<SingleJointCorrection>& joints,
                               const std::vector<DriverSeries>& drivers) {
  std::vector<Tried> result;
  for (const auto& [error, corners, pictures] : {std::tuple{Error::right, &errors.right, &errors.rightByPicture},
                                                 std::tuple{Error::down, &errors.down, &errors.downByPicture}}) {
    for (const Over over : {Over::column, Over::row}) {
      result.push_back(tryPair({.error = error, .over = over}, *corners, drivers));
    }
    for (std::size_t driver = 0; driver < drivers.size(); ++driver) {
      result.push_back(tryPair({.error = error, .driver = driver}, *pictures, drivers));
    }
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    for (std::size_t driver = 0; driver < drivers.size(); ++driver) {
      const std::size_t motor = joints[i].motor;
      if (drivers[driver].motor.value_or(motor) == motor) {
        result.push_back(tryPair({.error = Error::joint, .motor = motor, .driver = driver}, errors.joints[i], drivers));
      }
    }
  }
  return result;
}

Trend trendOf(const Tried& tried) {
  std::vector<TrendSample> samples;
  for (std::size_t i = 0; i < tried.x.size(); ++i) {
    const Value& value = (*tried.values)[i];
    samples.push_back({value.block, tried.x[i], value.y, value.weight});
  }
  return Trend{samples};
}

/// Shape of the curve, and the share of `squares` [px^2] that it removes.
void describePair(const Tried& tried, const Trend& trend, double squares, TellingPair& pair) {
  const std::vector<double> curve = trend.curve();
  double explained = 0, lowest = 0, highest = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Value& value = (*tried.values)[i];
    // a constant is no trend: (y - mean)^2 - (y - mean - t)^2
    explained += 2 * (value.slope - value.gram * trend.mean()) * curve[i] - value.gram * curve[i] * curve[i];
    const bool isFirst = i == 0 || tried.x[i] < lowest, isLast = i == 0 || tried.x[i] > highest;
    const double y = curve[i] + trend.mean();
    pair.from = isFirst ? y : pair.from;
    pair.to = isLast ? y : pair.to;
    lowest = isFirst ? tried.x[i] : lowest;
    highest = isLast ? tried.x[i] : highest;
    pair.least = i == 0 ? y : std::min(pair.least, y);
    pair.most = i == 0 ? y : std::max(pair.most, y);
  }
  pair.share = std::max(0.0, explained * (1 - trend.chanceShare()) / squares);
  pair.hasTwoValues = trend.valueCount() == 2;
}

/// Keeps pairs that differ: by driver or joint, or corners instead of a joint.
std::vector<TellingPair> selectDiffering(std::vector<TellingPair> pairs) {
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const TellingPair& a, const TellingPair& b) { return a.share > b.share; });
  std::vector<TellingPair> result;
  for (const TellingPair& pair : pairs) {
    const bool isNew = std::none_of(result.begin(), result.end(), [&](const TellingPair& one) {
      const bool sameOver = one.over == pair.over && (pair.over != Over::driver || one.driver == pair.driver);
      const bool bothJoints = one.error == Error::joint && pair.error == Error::joint;
      const bool bothCorners = one.error != Error::joint && pair.error != Error::joint;
      return (sameOver && (bothJoints || bothCorners)) || (bothJoints && one.motor == pair.motor);
    });
    if (isNew) {
      result.push_back(pair);
    }
  }
  return result;
}

std::string errorWords(const TellingPair& pair, const Robot& robot) {
  switch (pair.error) {
  case Error::right:
    return "rightward errors";
  case Error::down:
    return "downward errors";
  case Error::joint:
    break;
  }
  return fmt::format("the error of {} that would explain the misfit", robot.joints[pair.motor].name);
}

const DriverSeries* findDriver(const TellingPair& pair, const std::vector<DriverSeries>& drivers) {
  return pair.over == Over::driver ? &drivers[pair.driver] : nullptr;
}

/// Name of the quantity on the abscissa.
std::string formatDriver(const TellingPair& pair, const std::vector<DriverSeries>& drivers, const Robot& robot) {
  const DriverSeries* const driver = findDriver(pair, drivers);
  return driver != nullptr           ? describeDriver(*driver, robot)
         : pair.over == Over::column ? "the column in the picture"
                                     : "the row in the picture";
}

/// "6.0 px", "-0.41°", "0.35 mm" of a joint that slides; two significant digits.
std::string formatAmount(const TellingPair& pair, double value, const Robot& robot) {
  const bool isJoint = pair.error == Error::joint, slides = isJoint && robot.joints[pair.motor].isPrismatic;
  const std::string unit = slides ? "mm" : isJoint ? "°" : "px";
  const double shown = slides ? 1000 * value : isJoint ? degrees(value) : value;
  const double size = std::abs(shown);
  const int digits = size < 0.0995 ? 3 : size < 0.995 ? 2 : size < 9.95 ? 1 : 0;
  return (shown < 0 ? "−" : "") + appendUnit(fmt::format("{:.{}f}", size, digits), unit);
}

/// For example "go from A to B as the torque on LHipPitch grows".
std::string formatChange(const TellingPair& pair, const std::vector<DriverSeries>& drivers, const Robot& robot) {
  const bool one = pair.error == Error::joint; // singular
  const std::string over = formatDriver(pair, drivers, robot), from = formatAmount(pair, pair.from, robot),
                    to = formatAmount(pair, pair.to, robot);
  const DriverSeries* const driver = findDriver(pair, drivers);
  if (driver != nullptr && driver->kind == Driver::approach) {
    return fmt::format("{} {} where {} was approached from below and {} from above", one ? "is" : "are", to,
                       robot.joints[driver->joint].name, from); // +1: the last motion was upwards
  }
  if (pair.hasTwoValues) {
    return fmt::format("{} {} at the smaller and {} at the larger of two values of {}", one ? "is" : "are", from, to,
                       over);
  }
  constexpr double monotone = 0.8; // share of the curve's span between its ends, from which it counts as monotone
  if (std::abs(pair.to - pair.from) < monotone * (pair.most - pair.least)) {
    return fmt::format("{} between {} and {} with {}", one ? "varies" : "vary", formatAmount(pair, pair.least, robot),
                       formatAmount(pair, pair.most, robot), over);
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

TellingPairs findTellingPairs(const FittedModel& fitted, const std::vector<DriverSeries>& drivers,
                              const TellingOptions& options) {
  const auto rows =
      Residuals{fitted.measurements, fitted.model, fitted.fit.noise, fitted.fit.loss}.rows(fitted.fit.state);
  if (!rows) {
    return {};
  }
  TellingPairs result;
  result.joints = computeJointCorrections(fitted.measurements, *rows, fitted.fit.noise);
  const PlottableErrors errors = collectErrors(fitted, result.joints);
  const std::vector<Tried> all = tryAllPairs(errors, result.joints, drivers);
  std::vector<Trend> trends;
  for (const Tried& one : all) {
    trends.push_back(trendOf(one));
    result.tried += trends.back().isTestable();
  }
  const std::vector<double> chances = computeFamilyWiseChances(trends, options.draws, options.seed);
  const double squares = errors.squares() + readingSquares(fitted);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (chances[i] <= options.alarm) {
      TellingPair& pair = result.pairs.emplace_back(all[i].pair);
      pair.chance = chances[i];
      describePair(all[i], trends[i], squares, pair);
    }
  }
  result.pairs = selectDiffering(std::move(result.pairs));
  return result;
}

std::string describeDriver(const DriverSeries& driver, const Robot& robot) {
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

std::string formatTellingLabel(const TellingPair& pair, const std::vector<DriverSeries>& drivers, const Robot& robot) {
  const std::string error =
      pair.error == Error::joint ? fmt::format("error of {}", robot.joints[pair.motor].name) : errorWords(pair, robot);
  return fmt::format("{} over {}", error, formatDriver(pair, drivers, robot));
}

std::string formatTellingSentence(const TellingPair& pair, const std::vector<DriverSeries>& drivers,
                                  const Robot& robot) {
  const double small = std::min(std::abs(pair.from), std::abs(pair.to)),
               large = std::max(std::abs(pair.from), std::abs(pair.to));
  const DriverSeries* const driver = findDriver(pair, drivers);
  // ratio of the smaller to the larger side: above `turned` the error changes sign, above `even` "±" describes it
  constexpr double turned = 0.3, even = 0.7;
  const bool turns =
      driver != nullptr && driver->kind == Driver::approach && pair.from * pair.to < 0 && small > turned * large;
  std::string text = errorWords(pair, robot);
  if (turns) {
    const std::string size = small > even * large
                                 ? "±" + formatAmount(pair, (small + large) / 2, robot)
                                 : fmt::format("{} from below, {} from above", formatAmount(pair, pair.to, robot),
                                               formatAmount(pair, pair.from, robot));
    text += fmt::format(" ({}) {} sign with {}", size, pair.error == Error::joint ? "changes" : "change",
                        formatDriver(pair, drivers, robot));
  } else {
    text += " " + formatChange(pair, drivers, robot);
  }
  text[0] = static_cast<char>(std::toupper(text[0]));
  const double percent = 100 * std::min(1.0, pair.share);
  return text + (percent < 1 ? ". That is less than 1 % of the squared error."
                             : fmt::format(". That is {:.0f} % of the squared error.", percent));
}

std::string formatTellingSentence(const TellingPairs& telling, const std::vector<DriverSeries>& drivers,
                                  const Robot& robot) {
  if (!telling.pairs.empty()) {
    return formatTellingSentence(telling.pairs.front(), drivers, robot);
  }
  return telling.tried == 0
             ? "Too few poses to tell a trend from chance."
             : fmt::format("No trend beyond chance: none of {} pairs of error and driver stands out.", telling.tried);
}

} // namespace naocal
