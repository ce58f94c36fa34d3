#pragma once

#include "camera/ObservationChain.hpp"
#include "estimation/EffectJacobian.hpp"
#include "measurements/Measurements.hpp"
#include "measurements/Noise.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace naocal {

/// d(u), d(v) of four corners per unit of an extra (`ObservationChain::fillExtraRows`).
struct ExtraRow {
  Double4 u, v;
};

/// How far a sighting's corners count (`cornerShare`), among `repeats` pictures of one rest.
struct SightingWeight {
  double share = 1;
  std::size_t repeats = 1;
  /// Mean of share |r|^2 / pixel^2 per number: the repeats' mean has variance pixel^2 / share / repeats, differences
  /// from it have pixel^2.
  double freedom() const { return share + (1 - share) / static_cast<double>(repeats); }
};

/// Sums over corners, in the six numbers of the picture's motion and the extras: every derivative by any quantity is a
/// column of `ObservationChain::fillMotionColumns` times these, so their cost does not grow with the joints.
class ImageNormalEquations {
public:
  static constexpr int most = 6 + static_cast<int>(extraCount);
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;

  /// Forgets all corners.
  void clear(std::size_t extras = 0);

  /// Adds a sighting's corners. `extraRows`: extra after extra, each block after block.
  void add(const CornerBlocks& corners, const ProjectedBlocks& projected, const std::vector<ExtraRow>& extraRows,
           double pixelNoise, const SightingWeight& weight, const Loss& loss);

  Square gram() const;                             // sum of w L^T L, 6 + extras
  Column gradient() const;                         // sum of w L^T r, r = predicted - measured
  double squares() const { return sum(squares_); } // sum of w |r|^2 [px^2]
  double cost() const { return sum(cost_); }       // sum of rho [1], in units of the pixel noise squared
  double corners() const { return sum(corners_); } // sum of shares of those with w > 0
  double freedom() const { return sum(freedom_); } // what squares / pixel^2 of as many is in the mean

private:
  std::size_t width_ = 0;                   // 6 + extras
  Double4 products_[most * (most + 1) / 2]; // the gram's lower triangle, row after row
  Double4 gradient_[most];
  Double4 squares_, cost_, corners_, freedom_;
};

/// What a picture's residuals need that stays while the slopes do: links to walk, and which quantities move what in the
/// normal equations of its pose. Their columns are the pose's unknowns, then the deflections of its joints.
struct PreparedImage {
  /// Sightings that the same quantities move in the same way: their corners are summed up together.
  struct Group {
    std::vector<std::size_t> sightings;
    std::vector<std::size_t> quantities;
    std::vector<std::size_t> extras;   // among the quantities (`ObservationChain::extraIndex`)
    std::vector<Eigen::Index> columns; // that move them
    struct Share {
      Eigen::Index column, quantity; // places in the two lists above
      std::size_t slope;             // of d(quantity)/d(column), in `slopeValues`
    };
    std::vector<Share> shares;
  };
  std::vector<std::size_t> links;
  std::vector<std::size_t> joints;      // between camera and boards, that have a deflection
  std::vector<std::size_t> deflections; // theirs, among the pose's
  EffectJacobian slopes;
  std::vector<double> slopeValues; // 1 for a joint by its deflection, then the slopes
  std::vector<Group> groups;
  Group floor; // what moves the other sole, where the robot stands on both
  std::optional<ObservationChain>
      torso; // over the floor, where the inertial unit tells of it and its tilt is an unknown
  Group imu; // what moves the torso, and the unit in it
};

/// Finds links, groups and slope values, given joints, deflections and slopes. `unknowns`: of the picture's pose,
/// ascending.
void prepareImage(const Measurements& measurements, const ImageObservation& picture,
                  const std::vector<std::size_t>& unknowns, PreparedImage& prepared);

/// The normal equations of one pose: sums of w J^T J and w J^T r over its corners.
class NormalEquations {
public:
  void clear(Eigen::Index columns);

  /// Adds sums over L, the derivative by the picture's motion (and extras): J = L C, C = motion * (the group's shares
  /// of the slopes' values).
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
  std::vector<Four> moving_, half_; // C and L^T L C, four columns after four
};

} // namespace naocal
