#include "diagnose/Curves.hpp"

#include "diagnose/Shapes.hpp"
#include "evidence/Drivers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace naocal {

namespace {

/// The curve's points over its driver with their errors, from its coefficients; and half of its range. A joint is
/// approached from below, from nowhere that is known, or from above: there is nothing between.
void draw(const DriverCell& cell, const Eigen::VectorXd& estimate, const Eigen::MatrixXd& covariance,
          DriverFinding& finding) {
  const int points = finding.driver == "approach" ? static_cast<int>(std::lround(cell.most - cell.least)) + 1 : 41;
  double least = 0, most = 0;
  for (int i = 0; i < points; ++i) {
    const double x = std::lerp(cell.least, cell.most, static_cast<double>(i) / (points - 1));
    const Eigen::RowVectorXd basis = cell.basis(x);
    const double value = basis.dot(estimate);
    finding.curve.push_back({x, value, std::sqrt((basis * covariance * basis.transpose())(0, 0))});
    least = i == 0 ? value : std::min(least, value);
    most = i == 0 ? value : std::max(most, value);
  }
  finding.amplitude = (most - least) / 2;
}

/// How much of a joint's or mount's scatter from picture to picture a curve explains: its variance over the pictures as
/// they were taken, against the pose noise.
double shareOf(const DriverCell& cell, const std::vector<double>& driver, const Eigen::VectorXd& estimate,
               double left) {
  double sum = 0, squares = 0;
  for (const double x : driver) {
    const double value = cell.basis(x).dot(estimate);
    sum += value;
    squares += value * value;
  }
  const auto count = static_cast<double>(driver.size());
  const double variance = squares / count - std::pow(sum / count, 2);
  return variance > 0 ? variance / (variance + left * left) : 0;
}

void drawMount(const DriverCell& cell, const std::vector<double>& driver, const GroupEvidence& group, double scatter,
               DriverFinding& finding) {
  const std::array<const char*, 3> axes{"x", "y", "z"};
  finding.amplitude = -1;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto own = Eigen::seqN(axis, cell.count, 3);
    DriverFinding about = finding;
    about.about = axes[static_cast<std::size_t>(axis)];
    about.curve.clear();
    draw(cell, group.estimate(own), group.covariance(own, own), about);
    about.share = shareOf(cell, driver, group.estimate(own), scatter);
    if (about.amplitude > finding.amplitude) {
      finding = about;
    }
  }
}

/// A curve's name, as in a user's effect: a joint or camera, and what it varies with.
struct CurveName {
  std::string place, driver;
};

CurveName curveName(const Inquiry& inquiry, const Measurements& measurements, std::size_t curve) {
  const std::vector<DriverValues>& drivers = inquiry.map().drivers;
  if (curve < inquiry.mounts().size()) {
    const MountCurve& mount = inquiry.mounts()[curve];
    return {measurements.robot.cameras[mount.camera()].name, drivers[mount.cell.driver].name};
  }
  const DriverCell& cell = inquiry.map().cells[curve - inquiry.mounts().size()];
  return {measurements.robot.joints[cell.motor].name, nameAt(drivers[cell.driver], cell.motor)};
}

/// A curve as a finding; of a mount, about the axis that turns furthest.
DriverFinding driverFinding(const Inquiry& inquiry, const Measurements& measurements, std::size_t curve) {
  const CurveName name = curveName(inquiry, measurements, curve);
  const GroupEvidence& group = inquiry.ofCurve(curve);
  DriverFinding result{.place = name.place, .driver = name.driver};
  result.likelihoodRatio = group.likelihoodRatio;
  result.bayes = group.bayes;
  const bool ofMount = curve < inquiry.mounts().size();
  const DriverCell& cell =
      ofMount ? inquiry.mounts()[curve].cell : inquiry.map().cells[curve - inquiry.mounts().size()];
  const DriverValues& driver = inquiry.map().drivers[cell.driver];
  result.what = driver.what;
  if (ofMount) {
    drawMount(cell, driver.atPicture, group, inquiry.noise().pose, result);
  } else {
    result.share = shareOf(cell, driver.atPicture, group.estimate, inquiry.noise().pose);
    draw(cell, group.estimate, group.covariance, result);
    express(inquiry, measurements, cell, result);
  }
  return result;
}

/// Of each place and driver the curve that explains most, best first.
std::vector<std::size_t> bestCurves(const Inquiry& inquiry, const Measurements& measurements) {
  std::vector<std::size_t> result;
  std::set<std::pair<std::string, std::string>> seen;
  for (std::size_t curve : inquiry.curvesByEvidence()) {
    const CurveName name = curveName(inquiry, measurements, curve);
    if (seen.insert({name.place, name.driver}).second) {
      result.push_back(curve);
    }
  }
  return result;
}

} // namespace

void addMap(const Inquiry& inquiry, const Measurements& measurements, Diagnosis& diagnosis) {
  std::vector<std::size_t> best = bestCurves(inquiry, measurements);
  for (std::size_t i = 0; i < std::min<std::size_t>(3, best.size()); ++i) {
    diagnosis.drivers.push_back(driverFinding(inquiry, measurements, best[i]));
  }
  std::sort(best.begin(), best.end());
  for (std::size_t curve : best) {
    const CurveName name = curveName(inquiry, measurements, curve);
    diagnosis.map.push_back({name.place, name.driver, inquiry.ofCurve(curve).bayes, inquiry.ofCurve(curve).pValue});
  }
}

} // namespace naocal
