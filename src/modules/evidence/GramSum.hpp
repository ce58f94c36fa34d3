#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace naocal {

/// The sum of rows^T rows over many poses, each with columns of its own: taken together by the hundred, since a tall
/// matrix is multiplied faster than many flat ones.
class GramSum {
public:
  explicit GramSum(Eigen::Index columns);

  /// `columns`: which one each of the rows' columns is.
  void add(const std::vector<std::size_t>& columns, const Eigen::MatrixXd& rows);
  /// Symmetric; what was added so far.
  Eigen::MatrixXd taken();

private:
  void multiply();

  Eigen::MatrixXd sum_;     // its lower half
  Eigen::MatrixXd waiting_; // rows
  Eigen::Index count_ = 0;  // of rows that wait
};

} // namespace naocal
