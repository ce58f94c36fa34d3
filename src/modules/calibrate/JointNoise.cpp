#include "calibrate/JointNoise.hpp"

#include "geometry/Angles.hpp"
#include "geometry/InParallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlopt.h>

namespace naocal {

namespace {

constexpr double usualScatter = radians(0.02);

/// All poses and the prior at one noise level.
struct Total {
  Eigen::MatrixXd hessian;
  Eigen::VectorXd gradient;
  double cost = 0, logDeterminant = 0;
};

Total total(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns, const Eigen::VectorXd& sigmas,
            const Noise& noise) {
  const Eigen::VectorXd information = sigmas.cwiseAbs2().cwiseInverse();
  Total result{information.asDiagonal(), information.cwiseProduct(unknowns),
               0.5 * unknowns.cwiseAbs2().dot(information), 0};
  std::vector<Eliminated> parts(linear.poses.size());
  inParallel(parts.size(), [&](std::size_t i) {
    eliminate(linear.poses[i], noise, deflectionRoot(linear.poses[i], noise), parts[i]);
  });
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const std::vector<std::size_t>& seen = linear.poses[p].unknowns;
    const Eliminated& part = parts[p];
    result.gradient(seen) += part.unknownGradient;
    result.hessian(seen, seen) += part.hessian;
    result.cost += part.cost;
    result.logDeterminant += 2 * part.inner.matrixLLT().diagonal().array().log().sum();
  }
  return result;
}

/// -2 ln of the restricted likelihood, up to a constant.
double restrictedDeviance(const Total& all) {
  const Eigen::LLT<Eigen::MatrixXd> factor{all.hessian};
  return all.logDeterminant + 2 * factor.matrixLLT().diagonal().array().log().sum() + 2 * all.cost -
         all.gradient.dot(factor.solve(all.gradient));
}

constexpr double nothing = 1e-6, everything = 0.005; // [rad]: no stiction at all, and more than any NAO has

/// The search of the levels: x = (ln pose^2, ln encoder^2, ln stance^2), as many as the repeats tell.
struct Search {
  const Residuals::Linear& linear;
  const Eigen::VectorXd& unknowns;
  const Eigen::VectorXd& sigmas;
  Noise noise;
  Repeated repeated;

  Noise at(const double* x) const {
    Noise result = noise;
    const auto level = [](double squareLogarithm) {
      const double sigma = std::exp(squareLogarithm / 2);
      return sigma > 2 * nothing ? sigma : 0;
    };
    result.pose = level(x[0]);
    if (repeated.reapproached) {
      result.encoder = std::exp(x[1] / 2);
    }
    if (repeated.restood) {
      result.stance = level(x[2]);
    }
    return result;
  }
  double deviance(const double* x) const {
    const Noise levels = at(x);
    return restrictedDeviance(total(linear, unknowns, sigmas, levels)) + scatterPenalty(levels.stance);
  }
  static double call(unsigned, const double* x, double*, void* self) {
    return static_cast<const Search*>(self)->deviance(x);
  }
};

/// The pose level's posterior on a grid, the encoder's level held at its peak.
std::vector<JointNoise::Level> posterior(const Search& search, const Noise& peak) {
  constexpr int count = 16;
  const double reach = 4 * std::max(peak.pose, usualScatter);
  std::vector<JointNoise::Level> levels;
  double least = std::numeric_limits<double>::infinity();
  std::vector<double> deviances;
  for (int i = 0; i < count; ++i) {
    Noise noise = peak;
    noise.pose = reach * std::pow(static_cast<double>(i) / (count - 1), 2); // dense near zero
    deviances.push_back(restrictedDeviance(total(search.linear, search.unknowns, search.sigmas, noise)) +
                        scatterPenalty(noise.pose));
    least = std::min(least, deviances.back());
    levels.push_back({noise, std::max(1, 2 * i) / static_cast<double>(count)}); // width of the grid's cell
  }
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    levels[i].weight *= std::exp((least - deviances[i]) / 2);
    sum += levels[i].weight;
  }
  for (JointNoise::Level& level : levels) {
    level.weight /= sum;
  }
  std::erase_if(levels, [](const JointNoise::Level& level) { return level.weight < 1e-6; });
  return levels;
}

} // namespace

double scatterPenalty(double level) {
  const double ratio = level / usualScatter;
  return 2 * std::log1p(ratio * ratio);
}

JointNoise jointNoise(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns, const Eigen::VectorXd& sigmas,
                      const Noise& start, const Repeated& repeated) {
  Search search{linear, unknowns, sigmas, start, repeated};
  const double rounding = encoderStep / std::sqrt(12.0);
  std::vector<double> x{2 * std::log(3e-4)}, lower{2 * std::log(nothing)}, upper{2 * std::log(everything)};
  if (repeated.reapproached) {
    lower.push_back(2 * std::log(rounding));
    upper.push_back(2 * std::log(everything));
    x.push_back(std::max(2 * std::log(start.encoder), lower.back() + 0.5));
  }
  if (repeated.restood) {
    lower.push_back(2 * std::log(nothing));
    upper.push_back(2 * std::log(everything));
    x.push_back(2 * std::log(3e-4));
  }
  nlopt_opt optimiser = nlopt_create(NLOPT_LN_NELDERMEAD, static_cast<unsigned>(x.size()));
  nlopt_set_lower_bounds(optimiser, lower.data());
  nlopt_set_upper_bounds(optimiser, upper.data());
  nlopt_set_min_objective(optimiser, &Search::call, &search);
  nlopt_set_initial_step1(optimiser, 1); // a factor of 1.6 of a level
  nlopt_set_xtol_abs1(optimiser, 2e-2);
  nlopt_set_maxeval(optimiser, repeated.restood ? 160 : 80);
  double best = 0;
  nlopt_optimize(optimiser, x.data(), &best);
  nlopt_destroy(optimiser);
  JointNoise result{search.at(x.data()), {}};
  result.levels = posterior(search, result.noise);
  double variance = 0;
  for (const JointNoise::Level& level : result.levels) {
    variance += level.weight * level.noise.pose * level.noise.pose;
  }
  result.noise.pose = std::sqrt(variance);
  return result;
}

LinearMinimum linearMinimum(const Residuals::Linear& linear, const Eigen::VectorXd& unknowns,
                            const Eigen::VectorXd& sigmas, const Noise& noise) {
  const Total all = total(linear, unknowns, sigmas, noise);
  const Eigen::LLT<Eigen::MatrixXd> factor{all.hessian};
  return {-factor.solve(all.gradient), factor.solve(Eigen::MatrixXd::Identity(all.hessian.rows(), all.hessian.cols()))};
}

} // namespace naocal
