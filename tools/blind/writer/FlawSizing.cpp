#include "writer/FlawSizing.hpp"

#include <Eigen/SVD>
#include <cmath>

namespace blind {

namespace {

HiddenFlaw hiddenFlaw(const FlawFamily& family, const std::string& place, SizedFlaw flaw) {
  return {&family, place, std::move(flaw.values), flaw.noncentrality, flaw.kept};
}

} // namespace

FlawSizing::FlawSizing(const Robot& robot, const Session& session, const Noncentrality& noncentrality)
    : robot_{robot}, session_{session}, noncentrality_{noncentrality}, without_{Noncentrality::stacked(
                                                                           TruePictures{robot, session}, session)} {}

MeasuredChange FlawSizing::changeBy(const FlawFamily& family, const std::string& place) const {
  return [this, &family, &place](const std::vector<double>& values) { return change(family, place, values); };
}

Eigen::VectorXd FlawSizing::change(const FlawFamily& family, const std::string& place,
                                   std::span<const double> values) const {
  Robot robot = robot_;
  family.apply(robot.flaws, *robot.drawing, place, values);
  return Noncentrality::stacked(TruePictures{robot, session_}, session_) - without_;
}

HiddenFlaw FlawSizing::makeFlaw(const FlawFamily& family, const std::string& place, std::vector<double> values) const {
  return hiddenFlaw(family, place, weighFlaw(changeBy(family, place), noncentrality_, std::move(values)));
}

std::optional<HiddenFlaw> FlawSizing::scaleTo(const FlawFamily& family, const std::string& place,
                                              const std::vector<double>& shape, double wanted, double most) const {
  auto flaw = scaleFlaw(changeBy(family, place), noncentrality_, shape, wanted, most);
  return flaw ? std::optional{hiddenFlaw(family, place, std::move(*flaw))} : std::nullopt;
}

Eigen::MatrixXd FlawSizing::signatures(const HiddenFlaw& hidden) const {
  const std::size_t count = hidden.family->unknowns.size();
  Eigen::MatrixXd columns{without_.size(), static_cast<Eigen::Index>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double> values(count, 0.0);
    values[i] = 0.3 * hidden.family->unknowns[i].physical;
    columns.col(static_cast<Eigen::Index>(i)) = change(*hidden.family, hidden.place, values);
  }
  return columns;
}

double FlawSizing::correlation(const HiddenFlaw& first, const HiddenFlaw& second) const {
  const auto gram = [&](const Eigen::MatrixXd& left, const Eigen::MatrixXd& right) {
    Eigen::MatrixXd products{left.cols(), right.cols()};
    for (Eigen::Index i = 0; i < left.cols(); ++i) {
      for (Eigen::Index j = 0; j < right.cols(); ++j) {
        products(i, j) = noncentrality_.product(left.col(i), right.col(j));
      }
    }
    return products;
  };
  const Eigen::MatrixXd a = signatures(first), b = signatures(second);
  const Eigen::LLT<Eigen::MatrixXd> ofA{gram(a, a)}, ofB{gram(b, b)};
  const Eigen::MatrixXd half = ofA.matrixL().solve(gram(a, b));
  const Eigen::MatrixXd whitened = ofB.matrixL().solve(half.transpose());
  return whitened.jacobiSvd().singularValues()[0];
}

namespace {

/// A random direction, scaled by `size` of each unknown; nonnegative for flaws that cannot be negative.
template <typename Size> std::vector<double> drawnShape(const FlawFamily& family, Size size, RandomStream& chance) {
  std::vector<double> ofUnknowns;
  for (const FlawFamily::Unknown& unknown : family.unknowns) {
    ofUnknowns.push_back(size(unknown));
  }
  const bool neverNegative = family.effect == "backlash" || family.effect == "hysteresis" ||
                             family.effect == "gearPlay" || family.effect == "elasticity" ||
                             family.effect == "soleCompliance" || family.effect == "rollingShutter" ||
                             family.effect == "kneeRootSag";
  return drawShape(ofUnknowns, neverNegative, chance);
}

} // namespace

std::vector<double> randomShape(const FlawFamily& family, RandomStream& chance) {
  return drawnShape(
      family, [](const FlawFamily::Unknown& unknown) { return unknown.physical; }, chance);
}

std::vector<double> plausibleShape(const FlawFamily& family, RandomStream& chance) {
  return drawnShape(
      family, [](const FlawFamily::Unknown& unknown) { return unknown.wide(); }, chance);
}

void applyFlaw(const HiddenFlaw& hidden, Robot& robot) {
  hidden.family->apply(robot.flaws, *robot.drawing, hidden.place, hidden.values);
}

} // namespace blind
