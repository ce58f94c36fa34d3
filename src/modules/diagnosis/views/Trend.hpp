#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace naocal {

/// A value that may depend on a driver.
struct TrendSample {
  std::size_t block = 0; // block of poses, below `Trend::mostBlocks`
  double x = 0, y = 0;
  double weight = 1; // weight of y in the least-squares fit
};

/// Smooth trend of values over a driver, with significance judged by whole poses:
///
///   y - mean = sum_k b_k P_k(rank of x),   F = b^T V^-1 b / d,   V = (n - 1) / n sum_p (b_(-p) - b)(b_(-p) - b)^T
///
/// P_k: Legendre polynomials. Ranks run from -1 to 1, so that no single extreme value determines the curve; a driver
/// with few values has one step per value. b_(-p): fitted without pose p (delete-one jackknife over clusters; Efron,
/// The Jackknife (1982); Cameron & Miller, J. Human Resources 50 (2015) 317): errors common to the corners of a pose
/// count once, whether the driver varies within pictures or between poses. F is compared with F(d, n - 1 - d), accurate
/// enough to rank trends; `computeFamilyWiseChances` gives the significance.
class Trend {
public:
  /// Upper limit of jackknife blocks; with more poses, each block joins equally many neighbours.
  static constexpr std::size_t mostBlocks = 60;
  /// Block of a pose, given the number of poses.
  static std::size_t blockOf(std::size_t pose, std::size_t poses) {
    return pose / ((poses + mostBlocks - 1) / mostBlocks);
  }
  explicit Trend(const std::vector<TrendSample>& samples);

  /// False with too few poses, or if a single one dominates.
  bool isTestable() const { return degree_ > 0; }
  Eigen::Index degree() const { return degree_; }
  std::size_t valueCount() const { return values_; } // number of distinct driver values

  /// p-value of the curve under the hypothesis of no dependence. With signs (one per block): of the curve through the
  /// values with flipped signs.
  double pValue() const { return pValueOf(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(mostBlocks))); }
  double pValueOf(const Eigen::VectorXd& signs) const;

  double mean() const { return mean_; } // weighted mean of y
  /// The curve at each sample, in the given order, without the mean.
  std::vector<double> curve() const;
  /// Share of the curve's sum of squares due to errors of its coefficients, 0..1.
  double chanceShare() const;

private:
  using Few = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;
  struct Block {
    std::size_t number = 0;
    Square gram;           // sum of w b b^T, b = (1, P_1, ..)
    Few moment;            // sum of w b (y - mean)
    Square inverseWithout; // inverse gram of all other blocks
  };
  struct Fitted {
    Few coefficients; // without the constant
    Square variance;
  };
  bool prepare(const std::vector<TrendSample>& samples, Eigen::Index degree);
  Fitted fitSigned(const Eigen::VectorXd& signs) const;

  std::vector<double> ranks_; // per sample
  double mean_ = 0;
  std::size_t values_ = 0;
  Eigen::Index degree_ = 0;
  std::vector<Block> blocks_;
  Square gram_, inverse_;
};

/// Family-wise p-value of each trend: probability that the most significant of all trends is as significant under no
/// dependence, by random sign flips of whole poses, the same for all trends (Westfall & Young, Resampling-Based
/// Multiple Testing (1993), minP). 1 if not testable.
std::vector<double> computeFamilyWiseChances(const std::vector<Trend>& trends, Eigen::Index draws, std::uint64_t seed);

} // namespace naocal
