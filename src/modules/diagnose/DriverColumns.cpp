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

DriverColumns driverColumns(const Measurements& measurements, std::vector<DriverValues> drivers,
                            const std::vector<PoseSystem>& poses, Eigen::Index degree) {
  DriverColumns result{std::move(drivers), {}, 0, std::vector<std::vector<DriverColumns::Block>>(poses.size())};
  for (std::size_t motor : measurements.joints) {
    std::vector<Bent> bent;
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
      bent.push_back(bentBy(motor, measurements.poses[pose], poses[pose]));
    }
    const Eigen::Index firstColumn = result.count;
    std::vector<std::vector<double>> scaled; // per cell: the driver in [-1, 1]
    for (std::size_t driver = 0; driver < result.drivers.size(); ++driver) {
      if (result.drivers[driver].motor.value_or(motor) != motor) {
        continue;
      }
      std::vector<double> values = valuesAt(bent, result.drivers[driver]);
      const std::set<double> distinct(values.begin(), values.end());
      if (distinct.size() < 2 ||
          std::any_of(values.begin(), values.end(), [](double x) { return !std::isfinite(x); })) {
        continue;
      }
      const double middle = (*distinct.begin() + *distinct.rbegin()) / 2, half = *distinct.rbegin() - middle;
      for (double& value : values) {
        value = (value - middle) / half;
      }
      const Eigen::Index count = std::min(degree, at(distinct.size()) - 1);
      result.cells.push_back({motor, driver, result.count, count, middle, half});
      result.count += count;
      scaled.push_back(std::move(values));
    }
    std::size_t next = 0;
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
      const std::size_t rows = bent[pose].pictures.size();
      if (rows == 0 || result.count == firstColumn) {
        continue;
      }
      DriverColumns::Block block{bent[pose].first, firstColumn, Eigen::MatrixXd(at(rows), result.count - firstColumn)};
      const std::size_t firstCell = result.cells.size() - scaled.size();
      for (std::size_t cell = 0; cell < scaled.size(); ++cell) {
        const DriverCell& columns = result.cells[firstCell + cell];
        for (std::size_t row = 0; row < rows; ++row) {
          block.values.row(at(row)).segment(columns.first - firstColumn, columns.count) =
              curveBasis(scaled[cell][next + row], columns.count);
        }
      }
      next += rows;
      result.blocks[pose].push_back(std::move(block));
    }
  }
  return result;
}

} // namespace naocal
