#pragma once

#include "camera/ObservationChain.hpp"
#include "estimation/EffectJacobian.hpp"
#include "measurements/Measurements.hpp"
#include "measurements/Noise.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace naocal {

/// Weight of an observation's corners (`cornerShare`), given `repeats` pictures of one rest.
struct ObservationWeight {
  double share = 1;
  std::size_t repeats = 1;
  /// Expectation of share |r|^2 / pixel^2 per scalar measurement: the mean over repeats has variance pixel^2 / share /
  /// repeats, deviations from it have pixel^2.
  double freedom() const { return share + (1 - share) / static_cast<double>(repeats); }
};

/// Sums over corners in the six components of the picture's motion and the extras. A derivative with respect to any
/// quantity is a column of `ObservationChain::fillMotionColumns` times these sums, so their cost is independent of the
/// number of joints.
class ImageNormalEquations {
public:
  static constexpr int most = 6 + static_cast<int>(extraCount);
  static constexpr int mostOfAll = 6 + WitnessRows::mostOwn; // of any kind of measurement
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, mostOfAll, mostOfAll>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, mostOfAll, 1>;

  /// Resets the sums.
  void clear(std::size_t extras = 0);

  /// Adds the corners of an observation. `extraShifts`: ordered by extra, then by block.
  void add(const CornerBlocks& corners, const ProjectedBlocks& projected, const std::vector<CornerShift>& extraShifts,
           double pixelNoise, const ObservationWeight& weight, const Loss& loss);

  Square gram() const;                             // sum of w L^T L, 6 + extras
  Column gradient() const;                         // sum of w L^T r, r = predicted - measured
  double squares() const { return sum(squares_); } // sum of w |r|^2 [px^2]
  double cost() const { return sum(cost_); }       // sum of rho [1], in units of the pixel noise squared
  double corners() const { return sum(corners_); } // sum of the shares of corners with w > 0
  double freedom() const { return sum(freedom_); } // expectation of squares / pixel^2 per axis

private:
  std::size_t width_ = 0;                   // 6 + extras
  Double4 products_[most * (most + 1) / 2]; // lower triangle of the gram, row by row
  Double4 gradient_[most];
  Double4 squares_, cost_, corners_, freedom_;
};

/// Precomputed structure of a picture's residuals, valid for fixed slopes: links to evaluate, and which quantities
/// affect what in the normal equations of its pose. Columns: the pose's unknowns, then its joint deflections.
struct PreparedImage {
  /// Observations affected by the same quantities in the same way; their corners are summed together.
  struct Group {
    std::vector<std::size_t> observations;
    std::vector<std::size_t> quantities;
    std::vector<std::size_t> extras;   // indices among `quantities` (`ObservationChain::extraIndex`)
    std::vector<Eigen::Index> columns; // columns that affect the quantities
    struct Share {                     // 12 bytes: a wide model has a thousand per picture
      std::int32_t column, quantity;   // indices into the two lists above
      std::int32_t slope;              // index of d(quantity)/d(column) in `slopeValues`
    };
    std::vector<Share> shares;
  };
  std::vector<std::size_t> links;
  std::vector<std::size_t> joints;      // joints between camera and boards with a deflection
  std::vector<std::size_t> deflections; // index of each one's deflection in the pose
  EffectJacobian slopes;
  std::vector<double> slopeValues; // the slopes, then each joint's by its deflection
  std::vector<Group> groups;
  std::vector<Group> floors;             // affects each of the picture's other soles
  std::optional<ObservationChain> torso; // torso over the floor, if an IMU reading exists and its tilt is an unknown
  Group imu;                             // affects the torso and the IMU
  std::vector<Group> witnesses;          // affects each of the picture's witnesses
};

/// Computes links, groups and slope values from joints, deflections and slopes. `unknowns`: of the picture's pose,
/// ascending.
void prepareImage(const Measurements& measurements, const ImageObservation& picture,
                  const std::vector<std::size_t>& unknowns, PreparedImage& prepared);

/// The normal equations of one pose: sums of w J^T J and w J^T r over its corners.
class NormalEquations {
public:
  void clear(Eigen::Index columns);

  /// Adds sums over L, the derivative with respect to the picture's motion (and extras): J = L C, C = motion * (the
  /// group's shares of the slopes' values).
  void add(const ImageNormalEquations::Square& gram, const ImageNormalEquations::Column& gradient,
           const Eigen::MatrixXd& motion, const PreparedImage::Group& group, const double* slopeValues);

  const Eigen::MatrixXd& gram() const { return gram_; }
  const Eigen::VectorXd& gradient() const { return gradient_; }

private:
  template <int Rows>
  void addRows(const ImageNormalEquations::Square& gram, const ImageNormalEquations::Column& gradient,
               const Eigen::MatrixXd& motion, const PreparedImage::Group& group, const double* slopeValues);

  struct alignas(Double4) Four {
    double columns[4];
    Double4& lane() { return reinterpret_cast<Double4&>(columns); }
  };
  Eigen::MatrixXd gram_;
  Eigen::VectorXd gradient_;
  std::vector<Four> moving_, half_; // C and L^T L C, in blocks of four columns
};

} // namespace naocal
