#include "residuals/NormalEquations.hpp"

#include <algorithm>

namespace naocal {

void NormalEquations::clear(Eigen::Index columns) {
  gram_.setZero(columns, columns);
  gradient_.setZero(columns);
}

void NormalEquations::add(const PictureGram::Square& gram, const PictureGram::Column& gradient,
                          const Eigen::MatrixXd& motion, const PreparedPicture::Group& group,
                          const double* slopeValues) {
  if (group.extras.empty()) {
    addRows<6>(gram, gradient, motion, group, slopeValues);
  } else {
    addRows<Eigen::Dynamic>(gram, gradient, motion, group, slopeValues);
  }
}

/// `Rows` of the motion: six where there are no extras.
template <int Rows>
void NormalEquations::addRows(const PictureGram::Square& gram, const PictureGram::Column& gradient,
                              const Eigen::MatrixXd& motion, const PreparedPicture::Group& group,
                              const double* slopeValues) {
  const std::size_t rows = Rows == Eigen::Dynamic ? static_cast<std::size_t>(motion.rows()) : Rows;
  const std::size_t columns = group.columns.size(), fours = (columns + 3) / 4;
  moving_.assign(rows * fours, Four{});
  half_.resize(rows * fours);
  for (const PreparedPicture::Group::Share& share : group.shares) {
    Four* const four = &moving_[share.column / 4 * rows];
    const double slope = slopeValues[share.slope];
    for (std::size_t row = 0; row < rows; ++row) {
      four[row].columns[share.column % 4] += slope * motion(row, share.quantity);
    }
  }
  withWidestVectors([&]() __attribute__((always_inline)) {
    for (std::size_t four = 0; four < fours; ++four) {
      for (std::size_t i = 0; i < rows; ++i) {
        Lane sum{};
        for (std::size_t row = 0; row < rows; ++row) {
          sum += gram(row, i) * moving_[four * rows + row].lane();
        }
        half_[four * rows + i].lane() = sum;
      }
    }
    for (std::size_t column = 0; column < columns; ++column) {
      const Four* const own = &moving_[column / 4 * rows];
      const std::size_t lane = column % 4;
      double* const sums = &gram_(0, group.columns[column]);
      double sumOfGradient = 0;
      for (std::size_t row = 0; row < rows; ++row) {
        sumOfGradient += gradient[row] * own[row].columns[lane];
      }
      gradient_[group.columns[column]] += sumOfGradient;
      for (std::size_t four = 0; four < fours; ++four) {
        Lane sum{};
        for (std::size_t row = 0; row < rows; ++row) {
          sum += own[row].columns[lane] * half_[four * rows + row].lane();
        }
        Four taken;
        taken.lane() = sum;
        for (std::size_t i = 4 * four; i < std::min(4 * four + 4, columns); ++i) {
          sums[group.columns[i]] += taken.columns[i % 4];
        }
      }
    }
  });
}

} // namespace naocal
