#include "diagnose/FieldFinding.hpp"

#include "diagnose/BoardShape.hpp"
#include "diagnose/FieldBasis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace naocal {

namespace {

/// A field's value at a place: what it varies with (two), and its components with their errors.
struct FieldPoint {
  std::array<double, 2> drivers;
  Eigen::VectorXd value, sigma;
};

std::vector<FieldPoint> onBoard(const ImageField& field, const Measurements& measurements) {
  std::vector<FieldPoint> result;
  for (const BoardShape::Corner& corner : boardShape(field, measurements).corners) {
    result.push_back({{corner.place.x(), corner.place.y()}, corner.off, corner.sigma});
  }
  return result;
}

/// On a grid over a picture that is as wide as 2 cx.
std::vector<FieldPoint> inPicture(const FieldFit& fit, const Eigen::Vector2d& middle) {
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
    return onBoard(field, measurements);
  }
  const auto seen = std::find_if(measurements.pictures.begin(), measurements.pictures.end(),
                                 [&](const Picture& picture) { return picture.camera == field.at; });
  return inPicture(field.fit, seen->drawn.lens().segment<2>(2));
}

/// The mean of one component over each value of one driver.
std::vector<std::array<double, 3>> curveOf(const std::vector<FieldPoint>& points, std::size_t driver,
                                           Eigen::Index component) {
  struct Mean {
    double sum = 0, squares = 0, count = 0;
  };
  constexpr double alike = 1e4; // drivers that differ by less than a ten-thousandth
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

DriverFinding fieldFinding(const ImageField& field, const Measurements& measurements) {
  const bool board = field.of != ImageField::Of::camera;
  const std::array<const char*, 2> drivers = board ? std::array{"x", "y"} : std::array{"u", "v"};
  const std::array<const char*, 3> components = board ? std::array{"x", "y", "z"} : std::array{"u", "v", ""};
  DriverFinding result{.place =
                           board ? measurements.targets[field.at].name : measurements.robot.cameras[field.at].name};
  result.unit = board ? "m" : "px";
  result.bayes = field.fit.bayes;
  result.share = field.fit.share;
  result.amplitude = -1;
  const std::vector<FieldPoint> points = pointsOf(field, measurements);
  for (std::size_t driver = 0; driver < drivers.size(); ++driver) {
    for (Eigen::Index component = 0; component < (board ? 3 : 2); ++component) {
      std::vector<std::array<double, 3>> curve = curveOf(points, driver, component);
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
