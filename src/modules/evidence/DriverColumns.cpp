#include "evidence/DriverColumns.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace naocal {

namespace {

/// A motor's deflections of one pose: where they stand, and the pictures that each of them bends.
struct Bent {
  Eigen::Index first = 0;
  std::vector<std::vector<std::size_t>> pictures;
};

Bent bentBy(std::size_t motor, const PoseGroup& pose, const PosePart& part) {
  Bent result;
  for (std::size_t i = 0; i < part.joints.size(); ++i) {
    if (part.joints[i] != motor) {
      continue;
    }
    if (result.pictures.empty()) {
      result.first = at(i);
    }
    auto& pictures = result.pictures.emplace_back();
    for (const Reading& reading : pose.readings) {
      if (reading.encoderError[motor] == part.errors[i]) {
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
      result.push_back(driver.mean(pictures));
    }
  }
  return result;
}

/// All that a motor's deflection may follow over one driver.
std::vector<DriverCell> allShapes(const DriverValues& driver, std::size_t motor, const std::set<double>& distinct) {
  constexpr Eigen::Index degree = 4;
  std::vector<DriverCell> result{smoothCell(distinct, degree)};
  if (driver.kind == Driver::angle && driver.joint == motor) {
    const std::vector<DriverCell> waves = rippleCells();
    result.insert(result.end(), waves.begin(), waves.end());
  }
  if (driver.kind == Driver::time) {
    const std::vector<DriverCell> slips = stepCells(distinct);
    result.insert(result.end(), slips.begin(), slips.end());
  }
  if (driver.kind == Driver::torque && driver.joint == motor) {
    result.push_back(rootCell(distinct));
  }
  return result;
}

/// The columns of those cells that `shapesOf(driver, motor, distinct values)` makes.
template <typename ShapesOf>
DriverColumns columnsOf(const Measurements& measurements, std::vector<DriverValues> drivers,
                        const std::vector<PoseRows>& poses, const ShapesOf& shapesOf) {
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
      if (std::any_of(values.begin(), values.end(), [](double x) { return !std::isfinite(x); })) {
        continue;
      }
      const std::set<double> distinct = distinctValues(values);
      if (distinct.size() < 2) {
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

double DriverValues::mean(const std::vector<std::size_t>& pictures) const {
  double sum = 0;
  for (const std::size_t picture : pictures) {
    sum += atPicture[picture];
  }
  return sum / static_cast<double>(pictures.size());
}

DriverColumns driverColumns(const Measurements& measurements, std::vector<DriverValues> drivers,
                            const std::vector<PoseRows>& poses) {
  return columnsOf(measurements, std::move(drivers), poses, allShapes);
}

DriverColumns proportionalColumns(const Measurements& measurements, std::vector<DriverValues> drivers,
                                  const std::vector<PoseRows>& poses) {
  return columnsOf(measurements, std::move(drivers), poses,
                   [](const auto&, std::size_t, const auto& values) { return std::vector{smoothCell(values, 1)}; });
}

} // namespace naocal
