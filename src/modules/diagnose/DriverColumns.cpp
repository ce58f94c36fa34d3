#include "diagnose/DriverColumns.hpp"
#include "geometry/Index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace naocal {

namespace {

/// A motor's deflections of one pose: where they stand, and the pictures that each of them bends.
struct Bent {
  Eigen::Index first = 0;
  std::vector<std::vector<std::size_t>> pictures;
};

Bent bentBy(std::size_t motor, const PoseGroup& pose, const PoseSystem& system) {
  Bent result;
  for (std::size_t i = 0; i < system.joints.size(); ++i) {
    if (system.joints[i] != motor) {
      continue;
    }
    if (result.pictures.empty()) {
      result.first = at(i);
    }
    auto& pictures = result.pictures.emplace_back();
    for (const Reading& reading : pose.readings) {
      if (reading.encoderError[motor] == system.errors[i]) {
        pictures.insert(pictures.end(), reading.pictures.begin(), reading.pictures.end());
      }
    }
  }
  return result;
}

/// A driver at each of a motor's deflections, all poses one after the other.
std::vector<double> valuesAt(const std::vector<Bent>& bent, const DriverValues& driver) {
  std::vector<double> result;
  for (const Bent& pose : bent) {
    for (const auto& pictures : pose.pictures) {
      double sum = 0;
      for (std::size_t picture : pictures) {
        sum += driver.atPicture[picture];
      }
      result.push_back(sum / static_cast<double>(pictures.size()));
    }
  }
  return result;
}

/// Of the distinct values of a driver: the smooth cell over their range.
DriverCell smooth(const std::set<double>& distinct, Eigen::Index degree) {
  DriverCell cell;
  cell.middle = (*distinct.begin() + *distinct.rbegin()) / 2;
  cell.half = *distinct.rbegin() - cell.middle;
  cell.count = std::min(degree, at(distinct.size()) - 1);
  return cell;
}

std::vector<DriverCell> ripples() {
  constexpr int fewest = 2, most = 8; // once per turn is an effect with a name
  std::vector<DriverCell> result;
  for (int waves = fewest; waves <= most; ++waves) {
    DriverCell& cell = result.emplace_back();
    cell.shape = DriverCell::Shape::wave;
    cell.waves = waves;
    cell.count = 2;
    cell.choices = most - fewest + 1;
  }
  return result;
}

/// Steps halfway between moments, evenly chosen where there are many.
std::vector<DriverCell> steps(const std::set<double>& moments) {
  constexpr std::size_t most = 24;
  const std::vector<double> sorted(moments.begin(), moments.end());
  const std::size_t between = sorted.size() - 1, count = std::min(most, between);
  std::vector<DriverCell> result;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = count == 1 ? 0 : i * (between - 1) / (count - 1);
    DriverCell& cell = result.emplace_back();
    cell.shape = DriverCell::Shape::step;
    cell.middle = (sorted[before] + sorted[before + 1]) / 2;
    cell.count = 1;
    cell.choices = count;
  }
  return result;
}

/// All that a motor's deflection may follow over one driver.
std::vector<DriverCell> allShapes(const DriverValues& driver, std::size_t motor, const std::set<double>& distinct) {
  constexpr Eigen::Index degree = 4;
  std::vector<DriverCell> result{smooth(distinct, degree)};
  if (driver.kind == Driver::angle && driver.joint == motor) {
    const std::vector<DriverCell> waves = ripples();
    result.insert(result.end(), waves.begin(), waves.end());
  }
  if (driver.kind == Driver::time) {
    const std::vector<DriverCell> slips = steps(distinct);
    result.insert(result.end(), slips.begin(), slips.end());
  }
  if (driver.kind == Driver::torque && driver.joint == motor) {
    DriverCell& cell = result.emplace_back();
    cell.shape = DriverCell::Shape::root;
    cell.half = std::max(std::abs(*distinct.begin()), std::abs(*distinct.rbegin()));
    cell.count = 1;
  }
  return result;
}

/// The columns of those cells that `shapesOf(driver, motor, distinct values)` makes.
template <typename ShapesOf>
DriverColumns columnsOf(const Measurements& measurements, std::vector<DriverValues> drivers,
                        const std::vector<PoseSystem>& poses, const ShapesOf& shapesOf) {
  DriverColumns result{std::move(drivers), {}, 0, std::vector<std::vector<DriverColumns::Block>>(poses.size())};
  for (std::size_t motor : measurements.joints) {
    std::vector<Bent> bent;
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
      bent.push_back(bentBy(motor, measurements.poses[pose], poses[pose]));
    }
    const Eigen::Index firstColumn = result.count;
    const std::size_t firstCell = result.cells.size();
    std::vector<std::vector<double>> valuesOf; // per cell: of its driver
    for (std::size_t driver = 0; driver < result.drivers.size(); ++driver) {
      if (result.drivers[driver].motor.value_or(motor) != motor) {
        continue;
      }
      const std::vector<double> values = valuesAt(bent, result.drivers[driver]);
      const std::set<double> distinct(values.begin(), values.end());
      if (distinct.size() < 2 ||
          std::any_of(values.begin(), values.end(), [](double x) { return !std::isfinite(x); })) {
        continue;
      }
      for (DriverCell cell : shapesOf(result.drivers[driver], motor, distinct)) {
        cell.motor = motor;
        cell.driver = driver;
        cell.least = *distinct.begin();
        cell.most = *distinct.rbegin();
        cell.first = result.count;
        result.count += cell.count;
        result.cells.push_back(cell);
        valuesOf.push_back(values);
      }
    }
    std::size_t next = 0;
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
      const std::size_t rows = bent[pose].pictures.size();
      if (rows == 0 || result.count == firstColumn) {
        continue;
      }
      DriverColumns::Block block{bent[pose].first, firstColumn, Eigen::MatrixXd(at(rows), result.count - firstColumn)};
      for (std::size_t i = 0; i < valuesOf.size(); ++i) {
        const DriverCell& cell = result.cells[firstCell + i];
        for (std::size_t row = 0; row < rows; ++row) {
          block.values.row(at(row)).segment(cell.first - firstColumn, cell.count) = cell.basis(valuesOf[i][next + row]);
        }
      }
      next += rows;
      result.blocks[pose].push_back(std::move(block));
    }
  }
  return result;
}

} // namespace

Eigen::RowVectorXd curveBasis(double x, Eigen::Index count) {
  Eigen::RowVectorXd result(count);
  double before = 1, here = x; // P_0, P_1
  for (Eigen::Index n = 1; n <= count; ++n) {
    result[n - 1] = here;
    const auto degree = static_cast<double>(n);
    const double next = ((2 * degree + 1) * x * here - degree * before) / (degree + 1);
    before = here;
    here = next;
  }
  return result;
}

Eigen::RowVectorXd DriverCell::basis(double x) const {
  switch (shape) {
  case Shape::smooth:
    return curveBasis((x - middle) / half, count);
  case Shape::wave:
    return Eigen::RowVector2d{std::sin(waves * x), std::cos(waves * x)};
  case Shape::step:
    return Eigen::RowVectorXd::Constant(1, x > middle ? 1 : -1);
  case Shape::root:
    return Eigen::RowVectorXd::Constant(1, std::copysign(std::sqrt(std::abs(x) / half), x));
  }
  return {};
}

DriverColumns driverColumns(const Measurements& measurements, std::vector<DriverValues> drivers,
                            const std::vector<PoseSystem>& poses) {
  return columnsOf(measurements, std::move(drivers), poses, allShapes);
}

DriverColumns proportionalColumns(const Measurements& measurements, std::vector<DriverValues> drivers,
                                  const std::vector<PoseSystem>& poses) {
  return columnsOf(measurements, std::move(drivers), poses,
                   [](const auto&, std::size_t, const auto& values) { return std::vector{smooth(values, 1)}; });
}

} // namespace naocal
