#include "diagnose/TellingPairs.hpp"

#include "diagnose/Trend.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace naocal {

namespace {

using Error = TellingPair::Error;
using Over = TellingPair::Over;

/// A value with the pictures that it belongs to, and what taking a curve's value from it does to the squared errors:
/// 2 slope t - gram t^2 fewer square pixels.
struct Value {
  std::vector<std::size_t> pictures;
  std::size_t block = 0; // of poses
  double y = 0, weight = 1;
  double slope = 0, gram = 0;
  double column = 0, row = 0; // of a corner [px]
};

std::vector<std::size_t> blocksOfPictures(const Measurements& measurements) {
  std::vector<std::size_t> result = posesOfPictures(measurements);
  for (std::size_t& block : result) {
    block = Trend::blockOf(block, measurements.poses.size());
  }
  return result;
}

/// Predicted - measured of every corner that counts, as the joints were reported.
std::vector<Value> cornerErrors(const CalibrationResult& fit, const std::vector<std::size_t>& blocks, Error error) {
  const Eigen::Index axis = error == Error::right ? 0 : 1;
  std::vector<Value> result;
  for (std::size_t i = 0; i < fit.asReported.size(); ++i) {
    const SightingResidual& seen = fit.asReported[i];
    for (Eigen::Index corner = 0; corner < seen.residual.cols(); ++corner) {
      const double weight = fit.sightings[i].weight[corner]; // with the joints moved: only false corners lose theirs
      const double y = -seen.residual(axis, corner);
      if (weight > 0 && std::isfinite(y)) {
        const Eigen::Vector2d place = seen.predicted.col(corner) + seen.residual.col(corner);
        result.push_back({{seen.picture}, blocks[seen.picture], y, weight, weight * y, weight, place.x(), place.y()});
      }
    }
  }
  return result;
}

/// The corners of one picture as one value: what drives them from outside is the same for all.
std::vector<Value> byPicture(const std::vector<Value>& corners, std::size_t pictures) {
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

std::vector<Value> jointErrors(const WhatIfs& joint, const std::vector<std::size_t>& blocks) {
  std::vector<Value> result;
  for (const WhatIf& point : joint.points) {
    result.push_back({point.pictures, blocks[point.pictures.front()], point.deflection, 1 / (point.sigma * point.sigma),
                      -point.gradient, point.gram});
  }
  return result;
}

/// One pair that can be tried.
struct Tried {
  TellingPair pair;
  const std::vector<Value>* values = nullptr;
  std::vector<double> x; // per value
};

Tried tried(TellingPair pair, const std::vector<Value>& values, const std::vector<DriverValues>& drivers) {
  Tried result{pair, &values, {}};
  for (const Value& value : values) {
    result.x.push_back(pair.over == Over::column ? value.column
                       : pair.over == Over::row  ? value.row
                                                 : drivers[pair.driver].mean(value.pictures));
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

/// What the curve looks like, and the share of `squares` [px^2] that goes with it.
void describe(const Tried& tried, const Trend& trend, double squares, TellingPair& pair) {
  const std::vector<double> curve = trend.curve();
  double explained = 0, lowest = 0, highest = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Value& value = (*tried.values)[i];
    // what is the same everywhere is no trend: (y - mean)^2 - (y - mean - t)^2
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

/// The next best pair tells something new: another driver, another joint; or the same by corners instead of a joint.
std::vector<TellingPair> differing(std::vector<TellingPair> pairs) {
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

} // namespace

TellingPairs tellingPairs(const Measurements& measurements, const Model& model, const CalibrationResult& fit,
                          const std::vector<DriverValues>& drivers, const TellingOptions& options) {
  const auto rows = Residuals{measurements, model, fit.noise, fit.loss}.rows(fit.state);
  if (!rows) {
    return {};
  }
  TellingPairs result;
  result.joints = whatIfs(measurements, *rows, fit.noise);
  const std::vector<std::size_t> blocks = blocksOfPictures(measurements);
  const std::vector<Value> right = cornerErrors(fit, blocks, Error::right),
                           down = cornerErrors(fit, blocks, Error::down);
  const std::vector<Value> rightOf = byPicture(right, blocks.size()), downOf = byPicture(down, blocks.size());
  std::vector<std::vector<Value>> joints;
  double squares = 0;
  for (const std::vector<Value>* corners : {&right, &down}) {
    for (const Value& corner : *corners) {
      squares += corner.weight * corner.y * corner.y;
    }
  }
  for (const WhatIfs& joint : result.joints) {
    joints.push_back(jointErrors(joint, blocks));
  }

  std::vector<Tried> all;
  for (const auto& [error, corners, pictures] :
       {std::tuple{Error::right, &right, &rightOf}, std::tuple{Error::down, &down, &downOf}}) {
    for (const Over over : {Over::column, Over::row}) {
      all.push_back(tried({.error = error, .over = over}, *corners, drivers));
    }
    for (std::size_t driver = 0; driver < drivers.size(); ++driver) {
      all.push_back(tried({.error = error, .driver = driver}, *pictures, drivers));
    }
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    for (std::size_t driver = 0; driver < drivers.size(); ++driver) {
      const std::size_t motor = result.joints[i].motor;
      if (drivers[driver].motor.value_or(motor) == motor) {
        all.push_back(tried({.error = Error::joint, .motor = motor, .driver = driver}, joints[i], drivers));
      }
    }
  }
  std::vector<Trend> trends;
  for (const Tried& one : all) {
    trends.push_back(trendOf(one));
    result.tried += trends.back().isTestable();
  }
  const std::vector<double> chances = chancesAmongAll(trends, options.draws, options.seed);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (chances[i] <= options.alarm) {
      TellingPair& pair = result.pairs.emplace_back(all[i].pair);
      pair.chance = chances[i];
      describe(all[i], trends[i], squares, pair);
    }
  }
  result.pairs = differing(std::move(result.pairs));
  return result;
}

} // namespace naocal
