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

/// Monomials 1, x, y, x^2, x y, ... up to degree `most`.
Eigen::RowVectorXd monomials(const Eigen::Vector2d& at, int most);

/// Polynomials of degree 3 over a board's corner positions, scaled to about -1 to 1.
class SheetBasis {
public:
  explicit SheetBasis(const std::vector<Eigen::Vector3d>& points);

  Eigen::RowVectorXd basis(std::size_t corner) const;

private:
  const std::vector<Eigen::Vector3d>& points_;
  Eigen::AlignedBox2d box_;
};

/// One board in one picture, with its rigid motion projected out of the corner errors.
struct MotionFreeResidual {
  const BoardResidual* errors = nullptr; // r = measured - predicted [px] (elsewhere the opposite), L = `motionRows`,
                                         // W = `weight`
  const std::vector<int>* ids = nullptr; // of the corners
  std::size_t camera = 0, board = 0;
  Eigen::Matrix3d opticalFromBoard;
  std::size_t repeats = 0;             // index of its group: pictures of one board by one camera in one pose
  double share = 1;                    // 1 / number of pictures in the group
  Eigen::VectorXd weights;             // W, one per row
  Eigen::MatrixXd weighted;            // W L
  Eigen::LDLT<Eigen::MatrixXd> motion; // L^T W L

  /// d(predicted) of the i-th corner by its position on the board [px/m].
  Eigen::Matrix<double, 2, 3> cornerJacobian(std::size_t i) const {
    return errors->motionRows.block<2, 3>(2 * static_cast<Eigen::Index>(i), 3) * opticalFromBoard;
  }

  /// Residual columns (or r) after fitting the board's motion: C - L (L^T W L)^-1 L^T W C.
  Eigen::MatrixXd removeMotion(const Eigen::MatrixXd& columns) const;
};

/// Fit of field coefficients to motion-free residuals.
struct FieldFit {
  Eigen::VectorXd estimate; // of the coefficients, with prior; zero if undetermined
  Eigen::MatrixXd covariance;
  double freedom = 0; // number of determined coefficients; 0: undetermined
  double rmsPx = 0;   // explained rms, per axis of a corner
  double share = 0;   // share of the squared errors explained beyond the noise expectation
  double bayes = 0;   // 2 ln(Bayes factor) against zero coefficients, coefficients ~ N(0, plausible^2)
  double pValue = 1;  // probability of an equal explained share under noise alone (F)
};

/// Corner errors that no joint, link, mount or placement can cause: every board may move freely in every picture.
///
/// Small errors of detector and lens repeat while a pose is at rest. Therefore the mean over a pose's repeats counts as
/// one measurement, with noise estimated from these means, not from single corners.
class MotionFreeResiduals {
public:
  MotionFreeResiduals(const FittedModel& fitted);

  /// Fits `count` coefficients to the `chosen` observations; `columns`: derivative of the prediction with respect to
  /// the coefficients, two rows per corner. With too few measurements the result is undetermined (bayes 0, pValue 1).
  FieldFit fitField(Eigen::Index count, double plausible, const std::function<bool(const MotionFreeResidual&)>& chosen,
                    const std::function<Eigen::MatrixXd(const MotionFreeResidual&)>& columns) const;

  const std::vector<MotionFreeResidual>& observations() const { return observations_; }

private:
  std::vector<MotionFreeResidual> observations_;
};

/// Errors within pictures as a field: of one board in all pictures, or of one camera over all boards.
struct ImageField {
  enum class Of { corners, sheet, camera };
  Of of = Of::corners;
  std::size_t at = 0; // index of the board or camera
  FieldFit fit;
};

/// Field of a board's shape: free displacement of every corner in three directions [m], in board axes.
ImageField fitCornerField(const MotionFreeResiduals& errors, const Measurements& measurements, std::size_t board);

/// The same with polynomials of degree 3 over the board: fewer coefficients, more sensitive to smooth shapes [m].
ImageField fitSheetField(const MotionFreeResiduals& errors, const Measurements& measurements, std::size_t board);

/// Field of a lens: errors in u and v as polynomials of degree 4 over the picture [px].
ImageField fitCameraField(const MotionFreeResiduals& errors, const Measurements& measurements, std::size_t camera);

/// Refits the same kind of field to other errors.
ImageField refitField(const ImageField& field, const MotionFreeResiduals& errors, const Measurements& measurements);

/// The field with the most evidence, if significant and beyond `threshold::negligiblePx`.
std::optional<ImageField> findStrikingField(const FittedModel& fitted);

} // namespace naocal
