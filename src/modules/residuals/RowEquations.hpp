#pragma once

#include "residuals/PictureGram.hpp"
#include "residuals/PoseSystem.hpp"
#include "residuals/PreparedPicture.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// The rows of one pose (`PoseRows`): for each of its pictures' groups as many as its corners tell numbers apart.
class RowEquations {
public:
  void clear(Eigen::Index columns);

  /// Adds sums over L, the derivative by the picture's motion (and extras): the rows are U C with U^T U = `gram`,
  /// C = motion * (the group's shares of the slopes' values), and their residuals U^-T `gradient`.
  void add(const PictureGram::Square& gram, const PictureGram::Column& gradient, const Eigen::MatrixXd& motion,
           const PreparedPicture::Group& group, const double* slopeValues);

  /// Into `rows`, whose unknowns and joints are known: those columns, expressed at zero deflection.
  void take(const Eigen::VectorXd& deflections, PoseRows& rows) const;

private:
  Eigen::Index columns_ = 0;
  std::vector<Eigen::MatrixXd> parts_; // per group: its columns, then the residual
};

} // namespace naocal
