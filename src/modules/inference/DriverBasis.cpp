#include "inference/DriverBasis.hpp"

#include "estimation/DriverState.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <set>

namespace naocal {

namespace {

/// A motor's deflections in one pose: index of the first one, and the pictures that each affects.
struct Bent {
  Eigen::Index first = 0;
  std::vector<std::vector<std::size_t>> pictures;
};

Bent findBent(std::size_t motor, const PoseGroup& pose, const PosePart& part) {
  Bent result;
  for (std::size_t i = 0; i < part.joints.size(); ++i) {
    if (part.joints[i] != motor) {
      continue;
    }
    if (result.pictures.empty()) {
      result.first = eigenIndex(i);
    }
    auto& pictures = result.pictures.emplace_back();
    for (const EncoderSample& reading : pose.readings) {
      if (reading.encoderError[motor] == part.errors[i]) {
        pictures.insert(pictures.end(), reading.pictures.begin(), reading.pictures.end());
      }
    }
  }
  return result;
}

/// Driver value at each deflection of a motor, pose by pose.
std::vector<double> valuesAt(const std::vector<Bent>& bent, const DriverSeries& driver) {
  std::vector<double> result;
  for (const Bent& pose : bent) {
    for (const auto& pictures : pose.pictures) {
      result.push_back(driver.mean(pictures));
    }
  }
  return result;
}

/// All shapes that a motor's deflection may follow over one driver.
std::vector<DriverBasis> allShapes(const DriverSeries& driver, std::size_t motor, const std::set<double>& distinct) {
  constexpr Eigen::Index most = 4;
  const Eigen::Index degree = driver.kind == Driver::approach ? 1 : most; // 0: unknown, and no third direction
  std::vector<DriverBasis> result{polynomialBasis(distinct, degree)};
  if (driver.kind == Driver::angle && driver.joint == motor) {
    const std::vector<DriverBasis> waves = rippleBases();
    result.insert(result.end(), waves.begin(), waves.end());
  }
  if (driver.kind == Driver::time) {
    const std::vector<DriverBasis> slips = stepBases(distinct);
    result.insert(result.end(), slips.begin(), slips.end());
  }
  if (driver.kind == Driver::torque && driver.joint == motor) {
    result.push_back(rootBasis(distinct));
  }
  return result;
}

/// Adds the cells that `shapesOf(driver, motor, distinct values)` returns for a motor with these deflections. Returns
/// the driver values of each added cell.
template <typename ShapesOf>
std::vector<std::vector<double>> addCells(std::size_t motor, const std::vector<Bent>& bent, const ShapesOf& shapesOf,
                                          DriverColumns& columns) {
  std::vector<std::vector<double>> valuesOf;
  for (std::size_t driver = 0; driver < columns.drivers.size(); ++driver) {
    if (columns.drivers[driver].motor.value_or(motor) != motor) {
      continue;
    }
    const std::vector<double> values = valuesAt(bent, columns.drivers[driver]);
    if (std::any_of(values.begin(), values.end(), [](double x) { return !std::isfinite(x); })) {
      continue;
    }
    const std::set<double> distinct = distinctValues(values);
    if (distinct.size() < 2) {
      continue;
    }
    for (DriverBasis cell : shapesOf(columns.drivers[driver], motor, distinct)) {
      cell.motor = motor;
      cell.driver = driver;
      cell.least = *distinct.begin();
      cell.most = *distinct.rbegin();
      cell.first = columns.count;
      columns.count += cell.count;
      columns.cells.push_back(cell);
      valuesOf.push_back(values);
    }
  }
  return valuesOf;
}

/// Adds the blocks of the last cells, which belong to one motor with these deflections. `valuesOf`: driver values of
/// each cell.
void addBlocks(const std::vector<Bent>& bent, const std::vector<std::vector<double>>& valuesOf,
               DriverColumns& columns) {
  if (valuesOf.empty()) {
    return;
  }
  const DriverBasis* const cells = &columns.cells[columns.cells.size() - valuesOf.size()];
  const Eigen::Index firstColumn = cells->first;
  std::size_t next = 0;
  for (std::size_t pose = 0; pose < bent.size(); ++pose) {
    const std::size_t rows = bent[pose].pictures.size();
    if (rows == 0) {
      continue;
    }
    DriverColumns::Block block{bent[pose].first, firstColumn,
                               Eigen::MatrixXd(eigenIndex(rows), columns.count - firstColumn)};
    for (std::size_t i = 0; i < valuesOf.size(); ++i) {
      for (std::size_t row = 0; row < rows; ++row) {
        block.values.row(eigenIndex(row)).segment(cells[i].first - firstColumn, cells[i].count) =
            cells[i].basisAt(valuesOf[i][next + row]);
      }
    }
    next += rows;
    columns.blocks[pose].push_back(std::move(block));
  }
}

/// Columns of the cells returned by `shapesOf(driver, motor, distinct values)`.
template <typename ShapesOf>
DriverColumns buildColumns(const Measurements& measurements, std::vector<DriverSeries> drivers,
                           const std::vector<PoseRows>& poses, const ShapesOf& shapesOf) {
  DriverColumns result{std::move(drivers), {}, 0, std::vector<std::vector<DriverColumns::Block>>(poses.size())};
  for (std::size_t motor : measurements.joints) {
    std::vector<Bent> bent;
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
      bent.push_back(findBent(motor, measurements.poses[pose], poses[pose]));
    }
    addBlocks(bent, addCells(motor, bent, shapesOf, result), result);
  }
  return result;
}

/// Adds a driver unless a value is missing or all values are equal.
void add(std::vector<DriverSeries>& drivers, DriverSeries driver, const std::vector<RobotSample>& instants,
         const std::function<double(const RobotSample&)>& value) {
  for (const RobotSample& instant : instants) {
    driver.atPicture.push_back(value(instant));
  }
  const auto [least, most] = std::minmax_element(driver.atPicture.begin(), driver.atPicture.end());
  if (std::all_of(driver.atPicture.begin(), driver.atPicture.end(), [](double x) { return std::isfinite(x); }) &&
      *most - *least > leastChange) {
    drivers.push_back(std::move(driver));
  }
}

constexpr Eigen::Index mostPolynomials = 2;

/// Whether this joint is an ancestor of the camera in the kinematic tree.
bool carries(const Robot& robot, std::size_t joint, std::size_t camera) {
  std::optional<std::size_t> link = robot.cameras[camera].link;
  while (link && robot.links[*link].joint != joint) {
    link = robot.links[*link].parent;
  }
  return link.has_value();
}

bool canDrive(const DriverSeries& driver, const Robot& robot, std::size_t camera) {
  return driver.kind == Driver::time || (driver.kind == Driver::angle && carries(robot, driver.joint, camera));
}

double valueAt(const RobotSample& instant, Driver kind, std::size_t joint) {
  return kind == Driver::time ? instant.time.count() : instant.q[static_cast<Eigen::Index>(joint)];
}

Effect makeTurnEffect(const DriverSeries& driver, const DriverBasis& cell) {
  Effect effect{.name = "mountTurns",
                .description = {},
                .formula = {},
                .placeKind = PlaceKind::camera,
                .unknowns = {},
                .correct = [kind = driver.kind, joint = driver.joint, cell](ModelState& modelState,
                                                                            const RobotSample& instant, std::size_t,
                                                                            std::span<const double> values) {
                  const Eigen::RowVectorXd basis = cell.basisAt(valueAt(instant, kind, joint));
                  const Eigen::Map<const Eigen::Matrix3Xd> coefficients{values.data(), 3, cell.count};
                  modelState.mountRotation() += coefficients * basis.transpose();
                }};
  for (Eigen::Index n = 1; n <= cell.count; ++n) {
    for (const char* axis : {"x", "y", "z"}) {
      effect.unknowns.push_back({axis + std::to_string(n), "rad", curvePriorSigma});
    }
  }
  return effect;
}

} // namespace

Eigen::RowVectorXd legendre(double x, Eigen::Index count) {
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

Eigen::RowVectorXd DriverBasis::basisAt(double x) const {
  switch (shape) {
  case Shape::smooth:
    return legendre((x - middle) / half, count);
  case Shape::wave:
    return Eigen::RowVector2d{std::sin(waves * x), std::cos(waves * x)};
  case Shape::step:
    return Eigen::RowVectorXd::Constant(1, x > middle ? 1 : -1);
  case Shape::root:
    return Eigen::RowVectorXd::Constant(1, std::copysign(std::sqrt(std::abs(x) / half), x));
  }
  return {};
}

std::set<double> distinctValues(const std::vector<double>& values) {
  const std::set<double> sorted(values.begin(), values.end());
  std::set<double> result;
  for (const double value : sorted) {
    if (result.empty() || value - *result.rbegin() > leastChange) {
      result.insert(result.end(), value);
    }
  }
  return result;
}

DriverBasis polynomialBasis(const std::set<double>& distinct, Eigen::Index degree) {
  DriverBasis cell;
  cell.least = *distinct.begin();
  cell.most = *distinct.rbegin();
  cell.middle = (cell.least + cell.most) / 2;
  cell.half = cell.most - cell.middle;
  cell.count = std::min(degree, eigenIndex(distinct.size()) - 1);
  return cell;
}

std::vector<DriverBasis> rippleBases() {
  constexpr int fewest = 2, most = 8;
  std::vector<DriverBasis> result;
  for (int waves = fewest; waves <= most; ++waves) {
    DriverBasis& cell = result.emplace_back();
    cell.shape = DriverBasis::Shape::wave;
    cell.waves = waves;
    cell.count = 2;
    cell.choices = most - fewest + 1;
  }
  return result;
}

std::vector<DriverBasis> stepBases(const std::set<double>& times) {
  const std::vector<double> moments = midpointsOf(gapsBetween(times), 24);
  std::vector<DriverBasis> result;
  for (double moment : moments) {
    DriverBasis& cell = result.emplace_back();
    cell.shape = DriverBasis::Shape::step;
    cell.middle = moment;
    cell.count = 1;
    cell.choices = moments.size();
  }
  return result;
}

DriverBasis rootBasis(const std::set<double>& distinct) {
  DriverBasis cell;
  cell.shape = DriverBasis::Shape::root;
  cell.half = std::max(std::abs(*distinct.begin()), std::abs(*distinct.rbegin()));
  cell.count = 1;
  return cell;
}

std::vector<TimeGap> gapsBetween(const std::set<double>& times) {
  std::vector<TimeGap> result;
  for (auto time = times.begin(); time != times.end() && std::next(time) != times.end(); ++time) {
    result.emplace_back(*time, *std::next(time));
  }
  return result;
}

std::vector<double> midpointsOf(const std::vector<TimeGap>& gaps, std::size_t most) {
  const auto width = [](const TimeGap& gap) { return gap.second - gap.first; };
  const std::size_t parts = std::min(gaps.size(), most);
  std::vector<double> result;
  for (std::size_t part = 0; part < parts; ++part) {
    const auto begin = gaps.begin() + static_cast<std::ptrdiff_t>(part * gaps.size() / parts),
               end = gaps.begin() + static_cast<std::ptrdiff_t>((part + 1) * gaps.size() / parts);
    const TimeGap widest =
        *std::max_element(begin, end, [&](const TimeGap& a, const TimeGap& b) { return width(a) < width(b); });
    result.push_back((widest.first + widest.second) / 2);
  }
  return result;
}

double DriverSeries::mean(const std::vector<std::size_t>& pictures) const {
  double sum = 0;
  for (const std::size_t picture : pictures) {
    sum += atPicture[picture];
  }
  return sum / static_cast<double>(pictures.size());
}

DriverColumns buildDriverColumns(const Measurements& measurements, std::vector<DriverSeries> drivers,
                                 const std::vector<PoseRows>& poses) {
  return buildColumns(measurements, std::move(drivers), poses, allShapes);
}

DriverColumns buildProportionalColumns(const Measurements& measurements, std::vector<DriverSeries> drivers,
                                       const std::vector<PoseRows>& poses) {
  return buildColumns(measurements, std::move(drivers), poses, [](const auto&, std::size_t, const auto& values) {
    return std::vector{polynomialBasis(values, 1)};
  });
}

std::vector<DriverSeries> collectDrivers(const Measurements& measurements, const Model& model,
                                         const Eigen::VectorXd& unknowns) {
  std::vector<RobotSample> instants;
  for (const ImageObservation& picture : measurements.pictures) {
    instants.push_back(sampleAt(measurements, model, picture, unknowns));
  }
  std::vector<DriverSeries> drivers;
  for (std::size_t joint : measurements.joints) {
    const std::string& name = measurements.robot.joints[joint].name;
    const auto index = static_cast<Eigen::Index>(joint);
    const bool slides = measurements.robot.joints[joint].isPrismatic;
    add(drivers,
        {.kind = Driver::angle,
         .joint = joint,
         .name = name,
         .unit = slides ? "m" : "rad",
         .what = (slides ? "the position of " : "the angle of ") + name},
        instants, [index](const RobotSample& instant) { return instant.q[index]; });
    add(drivers,
        {.kind = Driver::torque,
         .joint = joint,
         .name = "tau_" + name,
         .unit = slides ? "N" : "Nm",
         .what = (slides ? "the force on " : "the torque on ") + name},
        instants, [index](const RobotSample& instant) { return instant.torque[index]; });
    add(drivers,
        {.kind = Driver::approach,
         .joint = joint,
         .name = "approach",
         .unit = "1",
         .what = "how it was approached",
         .motor = joint},
        instants, [index](const RobotSample& instant) { return instant.approach[index]; });
    add(drivers,
        {.kind = Driver::temperature,
         .joint = joint,
         .name = "T",
         .unit = "°C",
         .what = "its temperature",
         .motor = joint},
        instants, [index](const RobotSample& instant) { return instant.temperature[index]; });
    add(drivers,
        {.kind = Driver::velocity,
         .joint = joint,
         .name = "qd",
         .unit = slides ? "m/s" : "rad/s",
         .what = "its speed",
         .motor = joint},
        instants, [index](const RobotSample& instant) { return instant.velocity[index]; });
  }
  add(drivers, {.kind = Driver::time, .name = "t", .unit = "s", .what = "time"}, instants,
      [](const RobotSample& instant) { return instant.time.count(); });
  return drivers;
}

std::string expressionName(const DriverSeries& driver, std::size_t motor) {
  if (driver.joint == motor && driver.kind == Driver::angle) {
    return "q";
  }
  return driver.joint == motor && driver.kind == Driver::torque ? "tau" : driver.name;
}

std::vector<MountCurve> buildMountCurves(const Measurements& measurements, const std::vector<DriverSeries>& drivers) {
  std::vector<MountCurve> result;
  for (std::size_t camera = 0; camera < measurements.robot.cameras.size(); ++camera) {
    for (std::size_t i = 0; i < drivers.size(); ++i) {
      if (!canDrive(drivers[i], measurements.robot, camera)) {
        continue;
      }
      std::vector<double> values;
      for (std::size_t picture = 0; picture < measurements.pictures.size(); ++picture) {
        if (measurements.pictures[picture].camera == camera && !measurements.pictures[picture].observations.empty()) {
          values.push_back(drivers[i].atPicture[picture]);
        }
      }
      const std::set<double> distinct = distinctValues(values);
      if (distinct.size() < 2) {
        continue;
      }
      DriverBasis cell = polynomialBasis(distinct, mostPolynomials);
      cell.driver = i;
      result.push_back({{makeTurnEffect(drivers[i], cell), camera,
                         measurements.robot.cameras[camera].name + " over " + drivers[i].name},
                        cell});
    }
  }
  return result;
}

std::string describeDriver(const DriverSeries& driver, const Robot& robot) {
  const std::string& joint = robot.joints[driver.joint].name;
  switch (driver.kind) {
  case Driver::approach:
    return fmt::format("how {} was approached (−1: from above, 1: from below)", joint);
  case Driver::temperature:
    return fmt::format("the temperature of {}", joint);
  case Driver::velocity:
    return fmt::format("the speed of {}", joint);
  default:
    return driver.what;
  }
}

} // namespace naocal
