#include "diagnose/Curves.hpp"

#include "diagnose/Drivers.hpp"
#include "diagnose/Shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace naocal {

namespace {

/// The curve's points from `least` to `most` of its driver with their errors, from its coefficients; and half of its
/// range.
template <typename Basis>
void draw(const Eigen::VectorXd& estimate, const Eigen::MatrixXd& covariance, std::pair<double, double> range,
          const Basis& basisAt, DriverFinding& finding) {
  constexpr int points = 41;
  double least = 0, most = 0;
  for (int i = 0; i < points; ++i) {
    const double x = std::lerp(range.first, range.second, static_cast<double>(i) / (points - 1));
    const Eigen::RowVectorXd basis = basisAt(x);
    const double value = basis.dot(estimate);
    finding.curve.push_back({x, value, std::sqrt((basis * covariance * basis.transpose())(0, 0))});
    least = i == 0 ? value : std::min(least, value);
    most = i == 0 ? value : std::max(most, value);
  }
  finding.amplitude = (most - least) / 2;
}

void drawMount(const MountCurve& mount, const GroupEvidence& group, DriverFinding& finding) {
  const std::array<const char*, 3> axes{"x", "y", "z"};
  finding.amplitude = -1;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto own = Eigen::seqN(axis, mount.count, 3);
    DriverFinding about = finding;
    about.about = axes[static_cast<std::size_t>(axis)];
    about.curve.clear();
    draw(
        group.estimate(own), group.covariance(own, own), {mount.middle - mount.half, mount.middle + mount.half},
        [&](double x) { return curveBasis((x - mount.middle) / mount.half, mount.count); }, about);
    if (about.amplitude > finding.amplitude) {
      finding = about;
    }
  }
}

} // namespace

CurveName curveName(const Inquiry& inquiry, const Measurements& measurements, std::size_t curve) {
  const std::vector<DriverValues>& drivers = inquiry.map().drivers;
  if (curve < inquiry.mounts().size()) {
    const MountCurve& mount = inquiry.mounts()[curve];
    return {measurements.robot.cameras[mount.camera()].name, drivers[mount.driver].name};
  }
  const DriverCell& cell = inquiry.map().cells[curve - inquiry.mounts().size()];
  return {measurements.robot.joints[cell.motor].name, nameAt(drivers[cell.driver], cell.motor)};
}

DriverFinding driverFinding(const Inquiry& inquiry, const Measurements& measurements, std::size_t curve) {
  const CurveName name = curveName(inquiry, measurements, curve);
  const GroupEvidence& group = inquiry.ofCurve(curve);
  DriverFinding result{.place = name.place, .driver = name.driver};
  result.likelihoodRatio = group.likelihoodRatio;
  result.bayes = group.bayes;
  const double level = inquiry.evidence().level;
  result.share = level > 0 ? 1 - std::pow(group.level / level, 2) : 0;
  if (curve < inquiry.mounts().size()) {
    const MountCurve& mount = inquiry.mounts()[curve];
    result.what = inquiry.map().drivers[mount.driver].what;
    drawMount(mount, group, result);
  } else {
    const DriverCell& cell = inquiry.map().cells[curve - inquiry.mounts().size()];
    result.what = inquiry.map().drivers[cell.driver].what;
    draw(
        group.estimate, group.covariance, {cell.least, cell.most}, [&](double x) { return cell.basis(x); }, result);
    express(inquiry, measurements, cell, result);
  }
  return result;
}

} // namespace naocal
