#pragma once

#include "calibration/Calibration.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace naocal {

constexpr int lensDegree = 4;

/// 1, x, y, x^2, x y, ... up to a degree.
Eigen::RowVectorXd monomials(const Eigen::Vector2d& at, int most);

/// A board's polynomials of degree 3: of its corners' places, about -1 to 1 across.
class SheetBasis {
public:
  explicit SheetBasis(const std::vector<Eigen::Vector3d>& points);

  Eigen::RowVectorXd basis(std::size_t corner) const;

private:
  const std::vector<Eigen::Vector3d>& points_;
  Eigen::AlignedBox2d box_;
};

/// One board in one picture, its own rigid motion taken out of the corners' errors.
struct MotionFreeResidual {
  const BoardResidual* errors = nullptr; // r = measured - predicted [px], L = `motionRows`, W = `weight`
  const std::vector<int>* ids = nullptr; // of the corners
  std::size_t camera = 0, board = 0;
  Eigen::Matrix3d opticalFromBoard;
  std::size_t repeats = 0;             // the pictures that this pose has of this board by this camera, and
  double share = 1;                    // what each of them counts: 1 / their number
  Eigen::VectorXd weights;             // W, one per row
  Eigen::MatrixXd weighted;            // W L
  Eigen::LDLT<Eigen::MatrixXd> motion; // L^T W L

  /// d(predicted) of its i-th corner by that corner's place on the board [px/m].
  Eigen::Matrix<double, 2, 3> cornerJacobian(std::size_t i) const {
    return errors->motionRows.block<2, 3>(2 * static_cast<Eigen::Index>(i), 3) * opticalFromBoard;
  }

  /// What is left of columns (or of r) once the board may move: C - L (L^T W L)^-1 L^T W C.
  Eigen::MatrixXd removeMotion(const Eigen::MatrixXd& columns) const;
};

/// What coefficients of columns say about freed errors.
struct FieldFit {
  Eigen::VectorXd estimate; // of the coefficients, given that they are plausible; zero what is not told at all
  Eigen::MatrixXd covariance;
  double freedom = 0; // how many numbers the captures tell of them; 0: nothing is said
  double rmsPx = 0;   // of what the columns explain, per axis of a corner
  double share = 0;   // of the errors' squares that they explain beyond what noise would seem to
  double bayes = 0;   // 2 ln of the Bayes factor against none, coefficients ~ N(0, plausible^2)
  double pValue = 1;  // how often noise alone would seem to be explained as well (F)
};

/// Errors of corners that no joint, link, mount or placement makes: every board may lie anywhere in every picture.
///
/// A detector's and a lens's small errors repeat when a pose is at rest. So the mean over a pose's repeats counts as
/// one measurement, and its noise is what those means leave, not what corners leave.
class MotionFreeResiduals {
public:
  MotionFreeResiduals(const FittedModel& fitted);
  MotionFreeResiduals(const Measurements&, const Model&, CalibrationResult&&) = delete; // they point into it

  /// Fits `count` coefficients to the sightings that are `chosen`; `columns`: d(predicted) by the coefficients, two
  /// rows a corner. Too few measurements: nothing is said (bayes 0, pValue 1).
  FieldFit fitField(Eigen::Index count, double plausible, const std::function<bool(const MotionFreeResidual&)>& chosen,
                    const std::function<Eigen::MatrixXd(const MotionFreeResidual&)>& columns) const;

  const std::vector<MotionFreeResidual>& sightings() const { return sightings_; }

private:
  std::vector<MotionFreeResidual> sightings_;
};

/// Errors within pictures as a field: of one board, wherever it is seen, or of one camera, wherever boards appear.
struct ImageField {
  enum class Of { corners, sheet, camera };
  Of of = Of::corners;
  std::size_t at = 0; // which board or camera
  FieldFit fit;
};

/// Columns of a board's shape: every corner off in three directions [m], in the board's axes.
ImageField fitCornerField(const MotionFreeResiduals& errors, const Measurements& measurements, std::size_t board);

/// The same as polynomials of degree 3 over the board: few numbers, that tell smooth shapes from noise sooner [m].
ImageField fitSheetField(const MotionFreeResiduals& errors, const Measurements& measurements, std::size_t board);

/// Columns of a lens: errors to the right and down as polynomials of degree 4 over the picture [px].
ImageField fitCameraField(const MotionFreeResiduals& errors, const Measurements& measurements, std::size_t camera);

/// The same field in other errors.
ImageField refitField(const ImageField& field, const MotionFreeResiduals& errors, const Measurements& measurements);

/// The field that explains most, if any does beyond chance and beyond what a lens or a detector is known to [px].
std::optional<ImageField> findStrikingField(const FittedModel& fitted);

} // namespace naocal
