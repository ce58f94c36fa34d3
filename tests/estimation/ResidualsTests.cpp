#include "estimation/Residuals.hpp"

#include "MeasuredArm.hpp"
#include "TemporaryFolder.hpp"
#include "data/CaptureSetFile.hpp"
#include "estimation/MinimizedGradient.hpp"
#include "estimation/ModelBuilder.hpp"
#include "math/LinearAlgebra.hpp"
#include "simulation/HandMadePoses.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <set>

namespace naocal {
namespace {

struct Problem {
  explicit Problem(int poses = 3, RepeatKind kind = RepeatKind::reapproach)
      : robot{loadRobot(configurationDirectory(), "V6")} {
    SimulationPlan plan = handMadePlan(robot, poses);
    plan.samples = 2;
    plan.repeatKind = kind;
    plan.surveyed = true;
    plan.offsetRange = 0.01;
    plan.mountRange = 0.01;
    set = simulate(robot, plan, 5).set;
    measurements = buildMeasurements({set}, robot);
    model = buildModel(measurements, {"cameraTranslation@*", "radialDistortion@top"});
  }
  Robot robot;
  CaptureSet set;
  Measurements measurements;
  Model model;
};

/// Residuals of all corners of one pose, stacked, in a given state.
Eigen::VectorXd stacked(const Residuals& residuals, const Residuals::State& state, std::size_t pose) {
  std::vector<double> all;
  std::set<std::size_t> pictures;
  for (const EncoderSample& reading : residuals.measurements().poses[pose].readings) {
    pictures.insert(reading.pictures.begin(), reading.pictures.end());
  }
  for (const BoardResidual& seen : residuals.boardResiduals(state)) {
    if (pictures.contains(seen.picture)) {
      for (Eigen::Index i = 0; i < seen.residual.size(); ++i) {
        all.push_back(-seen.residual(i % 2, i / 2)); // predicted - measured
      }
    }
  }
  return Eigen::Map<Eigen::VectorXd>{all.data(), static_cast<Eigen::Index>(all.size())};
}

} // namespace

TEST_CASE("integrating out deflections equals the full covariance of all corners") {
  // Proves Woodbury identity, sums and chain rule together: hessian, gradient and cost of every pose are compared with
  // a dense Sigma = pixel^2 I + J S J^T from differences of predictions. Independent of the factoring by twists.
  const Problem problem{3, GENERATE(RepeatKind::rest, RepeatKind::reapproach)};
  const Noise noise{0.4, 6e-4, 9e-4};
  const Residuals residuals{problem.measurements, problem.model, noise};
  const Residuals::State state = residuals.startState(0.05 * problem.model.sigmas());
  const auto linear = residuals.linearize(state);
  REQUIRE(linear);
  for (std::size_t pose = 0; pose < linear->poses.size(); ++pose) {
    const PoseSystem& system = linear->poses[pose];
    const JointErrorRoot root = jointErrorRoot(system, noise);
    const Eigen::VectorXd r = stacked(residuals, state, pose);
    Eigen::MatrixXd byUnknown(r.size(), static_cast<Eigen::Index>(system.unknowns.size()));
    Eigen::MatrixXd byDeflection(r.size(), root.cols());
    for (Eigen::Index k = 0; k < byUnknown.cols(); ++k) {
      const auto unknown = static_cast<Eigen::Index>(system.unknowns[static_cast<std::size_t>(k)]);
      const double h = 1e-4 * problem.model.sigmas()[unknown];
      Residuals::State above = state, below = state;
      above.unknowns[unknown] += h;
      below.unknowns[unknown] -= h;
      byUnknown.col(k) = (stacked(residuals, above, pose) - stacked(residuals, below, pose)) / (2 * h);
    }
    for (Eigen::Index k = 0; k < root.cols(); ++k) { // z -> root z
      Residuals::State above = state, below = state;
      above.deflections[pose][k] += 0.01;
      below.deflections[pose][k] -= 0.01;
      byDeflection.col(k) = (stacked(residuals, above, pose) - stacked(residuals, below, pose)) / 0.02;
    }
    Eigen::MatrixXd sigma = byDeflection * byDeflection.transpose();
    sigma.diagonal().array() += noise.pixel * noise.pixel;
    const Eigen::LLT<Eigen::MatrixXd> factor{sigma};
    const Eigen::MatrixXd hessian = byUnknown.transpose() * factor.solve(byUnknown);
    const Eigen::VectorXd gradient = byUnknown.transpose() * factor.solve(r);
    const MarginalSystem part = marginalize(system, noise, root);
    CHECK((part.hessian - hessian).norm() < 1e-5 * hessian.norm());
    CHECK((part.unknownGradient - gradient).norm() < 1e-5 * gradient.norm());
    CHECK(part.cost == Approx(0.5 * r.dot(factor.solve(r))).epsilon(1e-6));
  }
}

TEST_CASE("the cost follows the unknowns alone, also where corners lose their weight") {
  // Proves by differences that the gradient is that of the cost minimised over all deflections, at zero deflections and
  // with most corners between full and zero weight, where a deflection optimised only once would need many steps.
  const Problem problem;
  const Noise noise{0.3, 6e-4, 9e-4};
  const Residuals residuals{problem.measurements, problem.model, noise, Loss{3}};
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(problem.model.sigmas().size());
  checkMinimizedGradient(residuals, zero, problem.model.sigmas(), 0.01);
}

TEST_CASE("a deflection root squares to encoder, pose and stance noise") {
  // Proves the prior covariance of a pose's joint errors: one error per reading, one shared by the joint, and one
  // shared within a stance.
  PoseSystem system;
  system.joints = {3, 3, 3, 7, 7};
  system.errorScales = {1, 1, 0.5, 1, 1};
  system.stances = {0, 0, 4, 0, 4};
  const Eigen::MatrixXd root = jointErrorRoot(system, {0.3, 2e-3, 1e-3});
  const Eigen::MatrixXd covariance = root * root.transpose();
  CHECK(covariance(0, 0) == Approx(5e-6));
  CHECK(covariance(0, 2) == Approx(1e-6));
  CHECK(covariance(2, 2) == Approx(2e-6));
  CHECK(covariance(2, 3) == Approx(0).margin(1e-18));
  CHECK(covariance(3, 4) == Approx(1e-6));
  const Eigen::MatrixXd restoodRoot = jointErrorRoot(system, {0.3, 2e-3, 1e-3, 3e-3});
  const Eigen::MatrixXd restood = restoodRoot * restoodRoot.transpose();
  CHECK(restood(0, 0) == Approx(14e-6));
  CHECK(restood(0, 1) == Approx(10e-6));
  CHECK(restood(0, 2) == Approx(1e-6));
  CHECK(restood(3, 4) == Approx(1e-6));
}

TEST_CASE("a resting joint keeps its rounding error, an approach gives it a new one") {
  // Proves the grouping of encoder errors, on which all statistics rely.
  for (const RepeatKind kind : {RepeatKind::rest, RepeatKind::reapproach}) {
    const Problem problem{3, kind};
    for (const PoseGroup& pose : problem.measurements.poses) {
      CHECK(pose.repeated == (kind == RepeatKind::reapproach));
      for (const EncoderSample& a : pose.readings) {
        const ImageObservation& pictureA = problem.measurements.pictures[a.pictures.front()];
        for (const EncoderSample& b : pose.readings) {
          const ImageObservation& pictureB = problem.measurements.pictures[b.pictures.front()];
          const bool rested = kind == RepeatKind::rest || problem.set.captures[pictureA.capture].repeat ==
                                                              problem.set.captures[pictureB.capture].repeat;
          CHECK((a.encoderError[0] == b.encoderError[0]) == rested);
          CHECK((!rested || pictureA.instant.q[0] == pictureB.instant.q[0]));
        }
      }
    }
  }
}

TEST_CASE("a reading that no flip explains is one of its own") {
  // Proves that angles differing by more than two steps during a rest are kept as read and share no encoder error.
  Problem problem{3, RepeatKind::rest};
  CaptureSet set = problem.set;
  const int odd = set.captures[2].id;
  set.captures[2].joints.measured[0] += 0.05;
  const double read = set.captures[2].joints.measured[0];
  const Measurements measurements = buildMeasurements({set}, problem.measurements.robot);
  for (const PoseGroup& pose : measurements.poses) {
    for (const EncoderSample& a : pose.readings) {
      for (const EncoderSample& b : pose.readings) {
        const auto isOdd = [&](const EncoderSample& reading) {
          return set.captures[measurements.pictures[reading.pictures.front()].capture].id == odd;
        };
        CHECK((a.encoderError[5] == b.encoderError[5]) == (isOdd(a) == isOdd(b)));
        CHECK((!isOdd(a) || measurements.pictures[a.pictures.front()].instant.q[0] == read));
      }
    }
  }
}

TEST_CASE("no order of captures changes a digit") {
  // Proves a canonical summation order: the linearisation is bitwise equal.
  Problem problem;
  CaptureSet shuffled = problem.set;
  std::shuffle(shuffled.captures.begin(), shuffled.captures.end(), std::mt19937{11});
  const Measurements other = buildMeasurements({shuffled}, problem.robot);
  const Residuals a{problem.measurements, problem.model, {}}, b{other, problem.model, {}};
  const Eigen::VectorXd unknowns = 0.1 * problem.model.sigmas();
  const auto left = a.linearize(a.startState(unknowns)), right = b.linearize(b.startState(unknowns));
  REQUIRE(left);
  REQUIRE(right);
  CHECK(left->cost == right->cost);
  CHECK(left->gradient == right->gradient);
  CHECK(left->hessian == right->hessian);
}

TEST_CASE("the loss is quadratic for good corners, constant for false ones and smooth between") {
  // Proves that the weight is the derivative of rho, as the acceptance test of the search requires.
  const Loss loss{1.5};
  for (double s = 0.5; s < 200; s += 0.37) {
    const double h = 1e-5;
    CHECK((loss(s + h).rho - loss(s - h).rho) / (2 * h) == Approx(loss(s).weight).margin(1e-5));
  }
  CHECK(loss(1.0).weight == 1);
  CHECK(loss(1e6).weight == 0);
  CHECK(loss(1e6).rho == loss(1e9).rho);
}

TEST_CASE("a hip yaw-pitch motor is one unknown under both of its names") {
  // Proves that neither name adds a second unknown, and that the right joint's name is accepted.
  const Problem problem;
  const Model model = buildModel(problem.measurements, {"jointOffset@RHipYawPitch"});
  CHECK(std::count_if(model.terms().begin(), model.terms().end(),
                      [](const Term& term) { return term.placeName.find("HipYawPitch") != std::string::npos; }) == 1);
  CHECK(buildModel(problem.measurements, {}, {"jointOffset@RHipYawPitch"}).unknownCount() == model.unknownCount() - 1);
}

TEST_CASE("a pose that is taken on two slopes has the torques of each") {
  // Proves that the cost of a model with an elastic joint does not depend on whether both slopes count as one pose.
  const TemporaryFolder folder;
  writeArmSet(folder.path());
  CaptureSet set = readCaptureSet(folder.path()).set;
  Placement slope;
  slope.roll = 1.2; // [rad]
  set.stances = {{.id = 0, .supportFoot = SupportFoot::none, .placement = Placement{}},
                 {.id = 1, .supportFoot = SupportFoot::none, .placement = slope}};
  const std::vector<Capture> level = set.captures;
  for (Capture capture : level) {
    capture.id += 1000;
    capture.stance = 1;
    capture.repeat = 1;
    capture.repeatKind = RepeatKind::restand;
    set.captures.push_back(capture);
  }
  CaptureSet apart = set;
  for (Capture& capture : apart.captures) {
    capture.pose += capture.stance == 1 ? " tilted" : "";
  }
  const Robot robot = parseUrdf(measuredArmUrdf, "arm.urdf");
  const auto costOf = [&](const CaptureSet& captures) {
    const Measurements measurements = buildMeasurements({captures}, robot);
    const Model model = buildModel(measurements, {"elasticity@lift"});
    Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(eigenIndex(model.unknownCount()));
    unknowns[eigenIndex(model.find("elasticity@lift")->first)] = 0.01; // [rad/Nm]
    const Residuals residuals{measurements, model, Noise{.encoder = 0}};
    return residuals.linearize(residuals.startState(unknowns)).value().cost;
  };
  CHECK(costOf(set) == Approx(costOf(apart)).epsilon(1e-9));
}

} // namespace naocal
