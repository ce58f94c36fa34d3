#include "diagnosis/views/DriverCurves.hpp"

#include "diagnosis/views/BoardShape.hpp"
#include "diagnosis/views/ImageField.hpp"
#include "inference/DriverBasis.hpp"
#include "io/Units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace naocal {

namespace {

/// Computes points of the curve with standard errors from its coefficients, and half of its range. The approach driver
/// has only its discrete values (from below, unknown, from above).
void draw(const DriverBasis& cell, const Eigen::VectorXd& estimate, const Eigen::MatrixXd& covariance,
          DriverCurve& finding) {
  const int points = finding.driver == "approach" ? static_cast<int>(std::lround(cell.most - cell.least)) + 1 : 41;
  double least = 0, most = 0;
  for (int i = 0; i < points; ++i) {
    const double x = std::lerp(cell.least, cell.most, static_cast<double>(i) / (points - 1));
    const Eigen::RowVectorXd basis = cell.basisAt(x);
    const double value = basis.dot(estimate);
    finding.curve.push_back({x, value, std::sqrt((basis * covariance * basis.transpose())(0, 0))});
    least = i == 0 ? value : std::min(least, value);
    most = i == 0 ? value : std::max(most, value);
  }
  finding.amplitude = (most - least) / 2;
}

/// Share of a joint's or mount's scatter that a curve explains: its variance over the pictures taken, relative to the
/// sum with the pose noise variance.
double shareOf(const DriverBasis& cell, const std::vector<double>& driver, const Eigen::VectorXd& estimate,
               double left) {
  double sum = 0, squares = 0;
  for (const double x : driver) {
    const double value = cell.basisAt(x).dot(estimate);
    sum += value;
    squares += value * value;
  }
  const auto count = static_cast<double>(driver.size());
  const double variance = squares / count - std::pow(sum / count, 2);
  return variance > 0 ? variance / (variance + left * left) : 0;
}

void drawMount(const DriverBasis& cell, const std::vector<double>& driver, const GroupEvidence& group, double scatter,
               DriverCurve& finding) {
  const std::array<const char*, 3> axes{"x", "y", "z"};
  finding.amplitude = -1;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto own = Eigen::seqN(axis, cell.count, 3);
    DriverCurve about = finding;
    about.about = axes[static_cast<std::size_t>(axis)];
    about.curve.clear();
    draw(cell, group.estimate(own), group.covariance(own, own), about);
    about.share = shareOf(cell, driver, group.estimate(own), scatter);
    if (about.amplitude > finding.amplitude) {
      finding = about;
    }
  }
}

/// Name of a curve as in a user-defined effect: joint or camera, and driver.
struct CurveName {
  std::string place, driver;
};

CurveName curveName(const CandidateTests& candidateTests, const Measurements& measurements, std::size_t curve) {
  const std::vector<DriverSeries>& drivers = candidateTests.map().drivers;
  if (curve < candidateTests.mounts().size()) {
    const MountCurve& mount = candidateTests.mounts()[curve];
    return {measurements.robot.cameras[mount.camera()].name, drivers[mount.cell.driver].name};
  }
  const DriverBasis& cell = candidateTests.map().cells[curve - candidateTests.mounts().size()];
  return {measurements.robot.joints[cell.motor].name, expressionName(drivers[cell.driver], cell.motor)};
}

/// A transformed driver, named by its expression.
DriverSeries transformDriver(const DriverSeries& driver, std::size_t motor, const std::string& expression,
                             const UnitPowers& unit, const std::function<double(std::size_t)>& value) {
  DriverSeries result{
      .kind = driver.kind, .joint = driver.joint, .name = expression, .unit = formatUnit(unit), .motor = motor};
  for (std::size_t i = 0; i < driver.atPicture.size(); ++i) {
    result.atPicture.push_back(value(i));
  }
  return result;
}

/// Shapes with a physical basis over one driver; related ones are adjacent.
std::vector<DriverSeries> shapes(const DriverSeries& driver, std::size_t motor,
                                 const std::vector<DriverSeries>& drivers) {
  const std::vector<double>& x = driver.atPicture;
  const std::string name = expressionName(driver, motor);
  const UnitPowers number, own = parseUnit(driver.unit).value_or(UnitPowers{{"K", 1}}),
                           root = multiplyUnits({}, own, 0.5); // °C counts as K
  std::vector<DriverSeries> result;
  const auto add = [&](const std::string& expression, const UnitPowers& unit,
                       const std::function<double(std::size_t)>& value) {
    result.push_back(transformDriver(driver, motor, expression, unit, value));
  };
  add(name, own, [&](std::size_t i) { return x[i]; });
  add(fmt::format("{}^2", name), multiplyUnits(own, own), [&](std::size_t i) { return x[i] * x[i]; });
  add(fmt::format("abs({})", name), own, [&](std::size_t i) { return std::abs(x[i]); });
  add(fmt::format("sign({})", name), number, [&](std::size_t i) { return x[i] > 0 ? 1 : x[i] < 0 ? -1 : 0; });
  add(fmt::format("sign({0})*sqrt(abs({0}))", name), root,
      [&](std::size_t i) { return std::copysign(std::sqrt(std::abs(x[i])), x[i]); });
  add(fmt::format("sqrt(abs({}))", name), root, [&](std::size_t i) { return std::sqrt(std::abs(x[i])); });
  if (driver.kind == Driver::angle) {
    for (int k = 1; k <= 8; ++k) {
      const std::string angle = k == 1 ? name : fmt::format("{}*{}", k, name);
      add(fmt::format("sin({})", angle), number, [&](std::size_t i) { return std::sin(k * x[i]); });
      add(fmt::format("cos({})", angle), number, [&](std::size_t i) { return std::cos(k * x[i]); });
    }
  }
  if (driver.kind == Driver::time) {
    std::vector<double> times = x;
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    for (std::size_t i = 1; i < times.size(); ++i) {
      const double at = (times[i - 1] + times[i]) / 2;
      add(fmt::format("({} > {:.6g} ? 1 : 0)", name, at), number, [&, at](std::size_t j) { return x[j] > at ? 1 : 0; });
    }
  }
  for (const DriverSeries& other : drivers) {
    if (other.kind == Driver::torque && other.joint == motor && driver.kind != Driver::torque) {
      add(fmt::format("{}*tau", name), multiplyUnits(own, {{"Nm", 1}}),
          [&](std::size_t i) { return x[i] * other.atPicture[i]; });
    }
  }
  return result;
}

bool isSineOf(const std::string& sine, const std::string& cosine) {
  return sine.starts_with("sin(") && cosine.starts_with("cos(") && sine.substr(4) == cosine.substr(4);
}

/// Adds to a finding the small expression that best follows the joint's misfit over its driver: linear, square, |x|,
/// sign, root, sines and cosines of x to 8x, a step in time, the driver times the joint's torque.
void fitExpression(const CandidateTests& candidateTests, const Measurements& measurements, const DriverBasis& cell,
                   DriverCurve& finding) {
  const std::vector<DriverSeries>& drivers = candidateTests.map().drivers;
  DriverColumns columns =
      buildProportionalColumns(measurements, shapes(drivers[cell.driver], cell.motor, drivers), candidateTests.poses());
  const std::vector<DriverBasis> single = columns.cells;
  const auto nameOf = [&](std::size_t i) { return columns.drivers[single[i].driver].name; };
  for (std::size_t i = 0; i + 1 < single.size(); ++i) {
    if (isSineOf(nameOf(i), nameOf(i + 1))) {
      columns.cells.push_back(single[i]);
      columns.cells.back().count = 2;
    }
  }
  ScoreProblem problem = candidateTests.problem();
  problem.map = &columns;
  problem.plausible = Eigen::VectorXd::Constant(problem.candidates + columns.count, curvePriorSigma);
  problem.groups.clear();
  problem.named = 0;
  for (const DriverBasis& shape : columns.cells) {
    problem.groups.push_back({problem.candidates + shape.first, shape.count});
  }
  const Evidence evidence = computeEvidence({problem, candidateTests.noise()});
  const auto best = std::max_element(evidence.groups.begin(), evidence.groups.end(),
                                     [](const auto& a, const auto& b) { return a.bayes < b.bayes; });
  if (best == evidence.groups.end()) {
    return;
  }
  const DriverBasis& shape = columns.cells[static_cast<std::size_t>(best - evidence.groups.begin())];
  for (std::size_t i = 0; i < single.size(); ++i) {
    const Eigen::Index column = single[i].first - shape.first;
    if (column >= 0 && column < shape.count) {
      const std::string coefficient = finding.coefficients.empty() ? "a" : "b";
      finding.expression += (finding.expression.empty() ? "" : " + ") + coefficient + "*" + nameOf(i);
      const UnitPowers unit = multiplyUnits({{"rad", 1}}, *parseUnit(columns.drivers[single[i].driver].unit), -1);
      finding.coefficients.push_back({coefficient, best->estimate[column] / single[i].half, formatUnit(unit)});
    }
  }
}

/// A curve as a finding; of a mount, about the axis with the largest rotation.
DriverCurve makeDriverCurve(const CandidateTests& candidateTests, const Measurements& measurements, std::size_t curve) {
  const CurveName name = curveName(candidateTests, measurements, curve);
  const GroupEvidence& group = candidateTests.curveEvidence(curve);
  DriverCurve result{.place = name.place, .driver = name.driver};
  result.likelihoodRatio = group.likelihoodRatio;
  result.bayes = group.bayes;
  const bool ofMount = curve < candidateTests.mounts().size();
  const DriverBasis& cell = ofMount ? candidateTests.mounts()[curve].cell
                                    : candidateTests.map().cells[curve - candidateTests.mounts().size()];
  const DriverSeries& driver = candidateTests.map().drivers[cell.driver];
  result.what = driver.what;
  result.isTransient = isTransient(driver.kind);
  if (ofMount) {
    drawMount(cell, driver.atPicture, group, candidateTests.noise().pose, result);
  } else {
    result.share = shareOf(cell, driver.atPicture, group.estimate, candidateTests.noise().pose);
    draw(cell, group.estimate, group.covariance, result);
    fitExpression(candidateTests, measurements, cell, result);
  }
  return result;
}

/// The curve with the most evidence for each pair of place and driver, best first.
std::vector<std::size_t> bestCurves(const CandidateTests& candidateTests, const Measurements& measurements) {
  std::vector<std::size_t> result;
  std::set<std::pair<std::string, std::string>> seen;
  for (std::size_t curve : candidateTests.curvesByEvidence()) {
    const CurveName name = curveName(candidateTests, measurements, curve);
    if (seen.insert({name.place, name.driver}).second) {
      result.push_back(curve);
    }
  }
  return result;
}

/// Value of a field at one point: the two drivers, and the components with standard errors.
struct FieldPoint {
  std::array<double, 2> drivers;
  Eigen::VectorXd value, sigma;
};

std::vector<FieldPoint> sampleOnBoard(const ImageField& field, const Measurements& measurements) {
  std::vector<FieldPoint> result;
  for (const BoardShape::Corner& corner : boardShapeFromField(field, measurements).corners) {
    result.push_back({{corner.place.x(), corner.place.y()}, corner.off, corner.sigma});
  }
  return result;
}

/// Samples a grid over a picture of width 2 cx.
std::vector<FieldPoint> sampleInPicture(const FieldFit& fit, const Eigen::Vector2d& middle) {
  constexpr int across = 9, down = 7;
  std::vector<FieldPoint> result;
  for (int column = 0; column < across; ++column) {
    for (int row = 0; row < down; ++row) {
      const Eigen::Vector2d at{std::lerp(-1.0, 1.0, column / (across - 1.0)),
                               std::lerp(-0.75, 0.75, row / (down - 1.0))};
      const Eigen::Vector2d pixel = middle + middle.x() * at;
      const Eigen::RowVectorXd basis = monomials(at, lensDegree);
      FieldPoint point{{pixel.x(), pixel.y()}, Eigen::VectorXd(2), Eigen::VectorXd(2)};
      for (Eigen::Index component = 0; component < 2; ++component) {
        const auto own = Eigen::seqN(component * basis.size(), basis.size());
        point.value[component] = basis.dot(fit.estimate(own));
        point.sigma[component] = std::sqrt((basis * fit.covariance(own, own) * basis.transpose())(0, 0));
      }
      result.push_back(std::move(point));
    }
  }
  return result;
}

std::vector<FieldPoint> pointsOf(const ImageField& field, const Measurements& measurements) {
  if (field.of != ImageField::Of::camera) {
    return sampleOnBoard(field, measurements);
  }
  const auto seen = std::find_if(measurements.pictures.begin(), measurements.pictures.end(),
                                 [&](const ImageObservation& picture) { return picture.camera == field.at; });
  return sampleInPicture(field.fit, seen->nominal.lens().segment<2>(2));
}

/// Mean of one component at each value of one driver.
std::vector<std::array<double, 3>> meanCurve(const std::vector<FieldPoint>& points, std::size_t driver,
                                             Eigen::Index component) {
  struct Mean {
    double sum = 0, squares = 0, count = 0;
  };
  constexpr double alike = 1e4; // 1 / resolution: drivers closer than 1e-4 count as equal
  std::map<long, Mean> means;
  for (const FieldPoint& point : points) {
    Mean& mean = means[std::lround(alike * point.drivers[driver])];
    mean.sum += point.value[component];
    mean.squares += std::pow(point.sigma[component], 2);
    mean.count += 1;
  }
  std::vector<std::array<double, 3>> curve;
  for (const auto& [value, mean] : means) {
    curve.push_back({static_cast<double>(value) / alike, mean.sum / mean.count, std::sqrt(mean.squares) / mean.count});
  }
  return curve;
}

double halfRange(const std::vector<std::array<double, 3>>& curve) {
  const auto [least, most] =
      std::minmax_element(curve.begin(), curve.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
  return curve.empty() ? 0 : ((*most)[1] - (*least)[1]) / 2;
}

} // namespace

DriverMap mapDrivers(const CandidateTests& candidateTests, const Measurements& measurements) {
  DriverMap map;
  std::vector<std::size_t> best = bestCurves(candidateTests, measurements);
  for (std::size_t i = 0; i < std::min<std::size_t>(3, best.size()); ++i) {
    map.best.push_back(makeDriverCurve(candidateTests, measurements, best[i]));
  }
  std::sort(best.begin(), best.end());
  for (std::size_t curve : best) {
    const CurveName name = curveName(candidateTests, measurements, curve);
    map.cells.push_back({name.place, name.driver, candidateTests.curveEvidence(curve).bayes,
                         candidateTests.curveEvidence(curve).pValue});
  }
  return map;
}

DriverCurve curveFromField(const ImageField& field, const Measurements& measurements) {
  const bool board = field.of != ImageField::Of::camera;
  const std::array<const char*, 2> drivers = board ? std::array{"x", "y"} : std::array{"u", "v"};
  const std::array<const char*, 3> components = board ? std::array{"x", "y", "z"} : std::array{"u", "v", ""};
  DriverCurve result{.place = board ? measurements.targets[field.at].name : measurements.robot.cameras[field.at].name};
  result.unit = board ? "m" : "px";
  result.bayes = field.fit.bayes;
  result.share = field.fit.share;
  result.amplitude = -1;
  const std::vector<FieldPoint> points = pointsOf(field, measurements);
  for (std::size_t driver = 0; driver < drivers.size(); ++driver) {
    for (Eigen::Index component = 0; component < (board ? 3 : 2); ++component) {
      std::vector<std::array<double, 3>> curve = meanCurve(points, driver, component);
      if (const double amplitude = halfRange(curve); amplitude > result.amplitude) {
        result.amplitude = amplitude;
        result.driver = drivers[driver];
        result.about = components[static_cast<std::size_t>(component)];
        result.curve = std::move(curve);
      }
    }
  }
  result.what = board ? "the place on the board" : "the place in the picture";
  return result;
}

} // namespace naocal
