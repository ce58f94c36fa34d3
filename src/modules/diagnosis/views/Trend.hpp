#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace naocal {

/// One value that may follow something that varies.
struct TrendSample {
  std::size_t block = 0; // of poses, below `Trend::mostBlocks`
  double x = 0, y = 0;
  double weight = 1; // of y, as in a weighted least squares fit
};

/// A smooth curve of values over what may drive them, told from chance by whole poses:
///
///   y - mean = sum_k b_k P_k(rank of x),   F = b^T V^-1 b / d,   V = (n - 1) / n sum_p (b_(-p) - b)(b_(-p) - b)^T
///
/// P_k: Legendre polynomials; ranks run from -1 to 1, so that no straggler holds the curve alone, and a driver that
/// keeps few values has a step for each. b_(-p): fitted without pose p (delete-one jackknife over clusters; Efron, The
/// Jackknife (1982); Cameron & Miller, J. Human Resources 50 (2015) 317): what the many corners of one pose share
/// counts once, whether the driver varies within pictures or between poses. F is compared with F(d, n - 1 - d), which
/// is near enough to compare trends with each other; how far chance goes is `computeFamilyWiseChances`'s to say.
class Trend {
public:
  /// No more blocks than that are left out in turn: of more poses, equally many neighbours make one.
  static constexpr std::size_t mostBlocks = 60;
  static std::size_t blockOf(std::size_t pose, std::size_t poses) {
    return pose / ((poses + mostBlocks - 1) / mostBlocks);
  }
  explicit Trend(const std::vector<TrendSample>& samples);

  /// False: too few poses, or a single one decides.
  bool isTestable() const { return degree_ > 0; }
  Eigen::Index degree() const { return degree_; }
  std::size_t valueCount() const { return values_; } // distinct ones of the driver

  /// The chance of a curve as clear as this where nothing follows the driver. With signs (one per
  /// block): of the curve that values turned round by these would make.
  double pValue() const { return pValueOf(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(mostBlocks))); }
  double pValueOf(const Eigen::VectorXd& signs) const;

  double mean() const { return mean_; } // of y
  /// The curve at each sample, in the order given; without the mean.
  std::vector<double> curve() const;
  /// How much of the curve's square is the error of its own coefficients, 0..1.
  double chanceShare() const;

private:
  using Few = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;
  struct Block {
    std::size_t number = 0;
    Square gram;           // sum of w b b^T, b = (1, P_1, ..)
    Few moment;            // sum of w b (y - mean)
    Square inverseWithout; // of all other blocks' gram
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

/// Of each trend the chance that the clearest of all of them is as clear where nothing follows anything: whole poses'
/// values turn round at random, alike for all trends (Westfall & Young, Resampling-Based Multiple Testing (1993),
/// minP). 1 for what cannot be tested.
std::vector<double> computeFamilyWiseChances(const std::vector<Trend>& trends, Eigen::Index draws, std::uint64_t seed);

} // namespace naocal
