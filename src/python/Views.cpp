#include "python/Views.hpp"

namespace naocal {

namespace py = pybind11;

namespace {

constexpr py::ssize_t step = sizeof(double); // [bytes]

/// `strides` [bytes].
template <class Number>
py::array makeView(const Number* first, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
                   py::handle owner) {
  py::array_t<Number> view{std::move(shape), std::move(strides), first, owner};
  view.attr("flags").attr("writeable") = false;
  return view;
}

} // namespace

py::array viewOf(const std::vector<double>& numbers, py::handle owner) {
  return makeView(numbers.data(), {std::ssize(numbers)}, {step}, owner);
}

py::array viewOf(const std::vector<int>& numbers, py::handle owner) {
  return makeView(numbers.data(), {std::ssize(numbers)}, {sizeof(int)}, owner);
}

py::array viewOf(const Eigen::VectorXd& numbers, py::handle owner) {
  return makeView(numbers.data(), {numbers.size()}, {step}, owner);
}

py::array viewOf(const Eigen::MatrixXd& matrix, py::handle owner) { // columns lie one after another
  return makeView(matrix.data(), {matrix.rows(), matrix.cols()}, {step, step * matrix.rows()}, owner);
}

py::array viewOf(const Eigen::Matrix2Xd& points, py::handle owner) {
  return makeView(points.data(), {points.cols(), 2}, {2 * step, step}, owner);
}

py::array viewOf(const std::vector<Eigen::Vector2d>& points, py::handle owner) {
  static_assert(sizeof(Eigen::Vector2d) == 2 * sizeof(double));
  return makeView(points.empty() ? nullptr : points.front().data(), {std::ssize(points), 2}, {2 * step, step}, owner);
}

py::array viewOf(const std::vector<std::array<double, 3>>& rows, py::handle owner) {
  return makeView(rows.empty() ? nullptr : rows.front().data(), {std::ssize(rows), 3}, {3 * step, step}, owner);
}

} // namespace naocal
