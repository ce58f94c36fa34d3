#pragma once

#include <Eigen/Core>
#include <array>
#include <pybind11/numpy.h>
#include <vector>

namespace naocal {

/// NumPy arrays over memory that a Python object owns: nothing is copied, the array keeps `owner` alive, and it cannot
/// be written. The memory must neither move nor change while `owner` lives. Shapes: (n,) for vectors, (n, 2) for
/// points, (rows, columns) for matrices.
pybind11::array viewOf(const std::vector<double>& numbers, pybind11::handle owner);
pybind11::array viewOf(const std::vector<int>& numbers, pybind11::handle owner);
pybind11::array viewOf(const Eigen::VectorXd& numbers, pybind11::handle owner);
pybind11::array viewOf(const Eigen::MatrixXd& matrix, pybind11::handle owner);
pybind11::array viewOf(const Eigen::Matrix2Xd& points, pybind11::handle owner);
pybind11::array viewOf(const std::vector<Eigen::Vector2d>& points, pybind11::handle owner);
pybind11::array viewOf(const std::vector<std::array<double, 3>>& rows, pybind11::handle owner);

} // namespace naocal
