#pragma once

#include "residuals/PictureGram.hpp"
#include "residuals/PreparedPicture.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// The normal equations of one pose: sums of w J^T J and w J^T r over its corners.
class NormalEquations {
public:
  void clear(Eigen::Index columns);

  /// Adds sums over L, the derivative by the picture's motion (and extras): J = L C, C = motion * (the group's shares
  /// of the slopes' values).
  void add(const PictureGram::Square& gram, const PictureGram::Column& gradient, const Eigen::MatrixXd& motion,
           const PreparedPicture::Group& group, const double* slopeValues);

  const Eigen::MatrixXd& gram() const { return gram_; }
  const Eigen::VectorXd& gradient() const { return gradient_; }

private:
  template <int Rows>
  void addRows(const PictureGram::Square& gram, const PictureGram::Column& gradient, const Eigen::MatrixXd& motion,
               const PreparedPicture::Group& group, const double* slopeValues);

  struct alignas(Lane) Four {
    double columns[4];
    Lane& lane() { return reinterpret_cast<Lane&>(columns); }
  };
  Eigen::MatrixXd gram_;
  Eigen::VectorXd gradient_;
  std::vector<Four> moving_, half_; // C and L^T L C, four columns after four
};

} // namespace naocal
