#include "diagnosis/views/BoardShape.hpp"

#include "diagnosis/views/ImageField.hpp"
#include "math/LinearAlgebra.hpp"

#include <cassert>

namespace naocal {

BoardShape boardShapeFromField(const ImageField& field, const Measurements& measurements) {
  assert(field.of != ImageField::Of::camera);
  const std::vector<Eigen::Vector3d>& points = measurements.targets[field.at].board.points;
  const SheetBasis sheet{points};
  BoardShape shape{.board = field.at, .corners = {}, .pValue = field.fit.pValue};
  for (std::size_t i = 0; i < points.size(); ++i) {
    Eigen::MatrixXd byCoefficients = Eigen::MatrixXd::Zero(3, field.fit.estimate.size());
    if (field.of == ImageField::Of::corners) {
      byCoefficients.middleCols<3>(eigenIndex(3 * i)).setIdentity();
    } else {
      const Eigen::RowVectorXd basis = sheet.basis(i);
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        byCoefficients.block(axis, axis * basis.size(), 1, basis.size()) = basis;
      }
    }
    const Eigen::Matrix3d covariance = byCoefficients * field.fit.covariance * byCoefficients.transpose();
    if (covariance.trace() > 0) { // zero if never observed
      shape.corners.push_back(
          {static_cast<int>(i), points[i], byCoefficients * field.fit.estimate, covariance.diagonal().cwiseSqrt()});
    }
  }
  return shape;
}

std::vector<BoardShape> estimateBoardShapes(const FittedModel& fitted) {
  const MotionFreeResiduals errors{fitted};
  std::vector<BoardShape> result;
  for (std::size_t board = 0; board < fitted.measurements.targets.size(); ++board) {
    if (const ImageField field = fitSheetField(errors, fitted.measurements, board); field.fit.freedom > 0) {
      result.push_back(boardShapeFromField(field, fitted.measurements));
    }
  }
  return result;
}

} // namespace naocal
