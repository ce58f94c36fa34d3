#include "diagnose/Shapes.hpp"

#include "evidence/Drivers.hpp"
#include "io/Units.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace naocal {

namespace {

/// Values of the driver transformed, as a driver of its own named by its expression.
DriverValues shaped(const DriverValues& driver, std::size_t motor, const std::string& expression, const Unit& unit,
                    const std::function<double(std::size_t)>& value) {
  DriverValues result{
      .kind = driver.kind, .joint = driver.joint, .name = expression, .unit = textOf(unit), .motor = motor};
  for (std::size_t i = 0; i < driver.atPicture.size(); ++i) {
    result.atPicture.push_back(value(i));
  }
  return result;
}

/// Shapes that physics has, of one driver; those that go together stand side by side.
std::vector<DriverValues> shapes(const DriverValues& driver, std::size_t motor,
                                 const std::vector<DriverValues>& drivers) {
  const std::vector<double>& x = driver.atPicture;
  const std::string name = nameAt(driver, motor);
  const Unit number, own = unitOf(driver.unit).value_or(Unit{{"K", 1}}), root = product({}, own, 0.5); // °C counts K
  std::vector<DriverValues> result;
  const auto add = [&](const std::string& expression, const Unit& unit,
                       const std::function<double(std::size_t)>& value) {
    result.push_back(shaped(driver, motor, expression, unit, value));
  };
  add(name, own, [&](std::size_t i) { return x[i]; });
  add(fmt::format("{}^2", name), product(own, own), [&](std::size_t i) { return x[i] * x[i]; });
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
  for (const DriverValues& other : drivers) {
    if (other.kind == Driver::torque && other.joint == motor && driver.kind != Driver::torque) {
      add(fmt::format("{}*tau", name), product(own, {{"Nm", 1}}),
          [&](std::size_t i) { return x[i] * other.atPicture[i]; });
    }
  }
  return result;
}

bool isSineOf(const std::string& sine, const std::string& cosine) {
  return sine.starts_with("sin(") && cosine.starts_with("cos(") && sine.substr(4) == cosine.substr(4);
}

} // namespace

void express(const Inquiry& inquiry, const Measurements& measurements, const DriverCell& cell, DriverFinding& finding) {
  const std::vector<DriverValues>& drivers = inquiry.map().drivers;
  DriverColumns columns =
      proportionalColumns(measurements, shapes(drivers[cell.driver], cell.motor, drivers), inquiry.poses());
  const std::vector<DriverCell> single = columns.cells;
  const auto nameOf = [&](std::size_t i) { return columns.drivers[single[i].driver].name; };
  for (std::size_t i = 0; i + 1 < single.size(); ++i) {
    if (isSineOf(nameOf(i), nameOf(i + 1))) {
      columns.cells.push_back(single[i]);
      columns.cells.back().count = 2;
    }
  }
  ScoreProblem problem = inquiry.problem();
  problem.map = &columns;
  problem.plausible = Eigen::VectorXd::Constant(problem.candidates + columns.count, plausibleCurve);
  problem.groups.clear();
  problem.named = 0;
  for (const DriverCell& shape : columns.cells) {
    problem.groups.push_back({problem.candidates + shape.first, shape.count});
  }
  const Evidence evidence = evidenceOf(problem, inquiry.noise());
  const auto best = std::max_element(evidence.groups.begin(), evidence.groups.end(),
                                     [](const auto& a, const auto& b) { return a.bayes < b.bayes; });
  const DriverCell& shape = columns.cells[static_cast<std::size_t>(best - evidence.groups.begin())];
  for (std::size_t i = 0; i < single.size(); ++i) {
    const Eigen::Index column = single[i].first - shape.first;
    if (column >= 0 && column < shape.count) {
      const std::string coefficient = finding.coefficients.empty() ? "a" : "b";
      finding.expression += (finding.expression.empty() ? "" : " + ") + coefficient + "*" + nameOf(i);
      const Unit unit = product({{"rad", 1}}, *unitOf(columns.drivers[single[i].driver].unit), -1);
      finding.coefficients.push_back({coefficient, best->estimate[column] / single[i].half, textOf(unit)});
    }
  }
}

} // namespace naocal
