#include "evidence/GramSum.hpp"

#include <algorithm>

namespace naocal {

namespace {

constexpr Eigen::Index together = 128; // rows

} // namespace

GramSum::GramSum(Eigen::Index columns)
    : sum_{Eigen::MatrixXd::Zero(columns, columns)}, waiting_{Eigen::MatrixXd::Zero(together, columns)} {}

void GramSum::add(const std::vector<std::size_t>& columns, const Eigen::MatrixXd& rows) {
  for (Eigen::Index first = 0; first < rows.rows(); first += together) {
    const Eigen::Index count = std::min(together, rows.rows() - first);
    if (count_ + count > together) {
      multiply();
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      waiting_.col(static_cast<Eigen::Index>(columns[i])).segment(count_, count) =
          rows.col(static_cast<Eigen::Index>(i)).segment(first, count);
    }
    count_ += count;
  }
}

Eigen::MatrixXd GramSum::taken() {
  multiply();
  return sum_.selfadjointView<Eigen::Lower>();
}

void GramSum::multiply() {
  if (count_ == 0) { // Eigen divides by the number of rows
    return;
  }
  sum_.selfadjointView<Eigen::Lower>().rankUpdate(waiting_.topRows(count_).transpose());
  waiting_.topRows(count_).setZero();
  count_ = 0;
}

} // namespace naocal
