#include "estimation/MinimizedGradient.hpp"
#include "estimation/ModelBuilder.hpp"
#include "estimation/Residuals.hpp"
#include "math/LevenbergMarquardt.hpp"
#include "math/LinearAlgebra.hpp"
#include "measurements/WitnessSource.hpp"
#include "robot/Kinematics.hpp"
#include "robot/Urdf.hpp"

#include <catch2/catch.hpp>
#include <random>

namespace naocal {
namespace {

/// Three turning joints about different axes, rotated steps, and a slide.
const std::string armUrdf = R"(<robot name="arm">
  <link name="base"/><link name="upper"><inertial><origin xyz="0 0.02 0.2"/><mass value="1.5"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="fore"><inertial><origin xyz="0.1 0 0.1"/><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="slider"/><link name="hand"/>
  <joint name="turn" type="revolute"><parent link="base"/><child link="upper"/><origin xyz="0 0 0.3" rpy="0.1 0 0"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
  <joint name="lift" type="revolute"><parent link="upper"/><child link="fore"/><origin xyz="0.05 0 0.4" rpy="0 0.3 0.2"/><axis xyz="0 1 0"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
  <joint name="slide" type="prismatic"><parent link="fore"/><child link="slider"/><origin xyz="0.2 0 0.1" rpy="0 0.2 0"/><axis xyz="1 0 0"/><limit lower="0" upper="0.3" velocity="1" effort="1"/></joint>
  <joint name="roll" type="revolute"><parent link="slider"/><child link="hand"/><origin xyz="0.2 0 0" rpy="0 0 -0.7"/><axis xyz="0.6 0 0.8"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
</robot>)";

RigidTransform pose(double x, double y, double z, double roll, double pitch, double yaw) {
  return transformFromPlacement((Twist{} << x, y, z, roll, pitch, yaw).finished());
}

/// Where everything is. The tracker looks straight up, where roll, pitch and yaw lock.
const RigidTransform worldFromTracker = pose(1, -2, 0.5, 0.2, -1.57, 0.4),
                     handFromFrame = pose(0.02, 0.03, 0.1, 2, 1.5, -1);
const Eigen::Vector3d markerInHand{0.03, -0.02, 0.12};

/// Readings of an arm whose joints' zeros are off by `offset`: a tracker's points and frames, and touches of places,
/// each place in two attitudes that differ by a turn about the marker.
CaptureSet measuredArm(const Robot& robot, const Eigen::Vector4d& offset, bool mimics = false) {
  CaptureSet set;
  set.name = "arm";
  set.version = 2;
  set.model.clear();
  set.urdf = "arm.urdf";
  set.jointNames = {"turn", "lift", "slide", "roll"};
  set.instruments.trackers = {{"vicon", 0.0005, std::nullopt, std::nullopt}};
  set.instruments.markers = {{.id = "ball", .link = "hand", .pointGuess = {0, 0, 0.1}}};
  set.instruments.frames = {{"tool", "hand", std::nullopt}};
  set.stances = {{.id = 0, .supportFoot = SupportFoot::none}};
  std::mt19937_64 random{5};
  std::uniform_real_distribution<double> uniform{-1, 1};
  for (int i = 0; i < 24; ++i) {
    Eigen::Vector4d read{2 * uniform(random), uniform(random), 0.15 + 0.1 * uniform(random), 2 * uniform(random)};
    read[3] = mimics ? -0.5 * read[1] + 0.1 : read[3];
    const RigidTransform hand = forwardKinematics(robot, Eigen::VectorXd{read - offset})[*robot.linkIndex("hand")];
    Capture capture{.id = i, .pose = "P" + std::to_string(i), .time = Seconds{i}};
    capture.supportFoot = SupportFoot::none;
    capture.joints.measured.assign(read.begin(), read.end());
    const RigidTransform trackerFromFrame = worldFromTracker.inverse() * hand * handFromFrame;
    capture.points = {{"vicon", "ball", worldFromTracker.inverse() * (hand * markerInHand)}};
    capture.frames = {{"vicon", "tool", trackerFromFrame.translation, Eigen::Quaterniond{trackerFromFrame.rotation}}};
    const std::string place = "place " + std::to_string(i);
    set.instruments.places.push_back({place, std::nullopt});
    capture.contacts = {{"ball", place}};
    if (i > 0) {
      const Eigen::Vector3d here = hand * markerInHand;
      static Eigen::Vector3d before;
      if (i > 1) {
        set.instruments.distances.push_back({{"place " + std::to_string(i - 1), place}, (here - before).norm(), 2e-5});
      }
      before = here;
    }
    set.captures.push_back(std::move(capture));
  }
  return set;
}

/// Height of a point of a link over z = 0 of the world, as a range finder reads it: a kind of measurement of its own.
class RangeFinder final : public Witness {
public:
  RangeFinder(std::size_t level, double height) : Witness{{{0, 1, level}}, {}, "beam"}, height_{height} {}

  WitnessRows compare(const RigidTransform& linkFromWorld, const ModelState&) const override {
    const RigidTransform worldFromLink = linkFromWorld.inverse();
    const Eigen::Vector3d point{0.01, 0.02, 0.03};
    WitnessRows rows{WitnessRows::Column::Constant(1, (worldFromLink * point).z() - height_),
                     WitnessRows::ByMotion(1, 6), WitnessRows::ByOwn(1, 0)};
    rows.byMotion << (worldFromLink.rotation * crossMatrix(point)).row(2), -worldFromLink.rotation.row(2);
    return rows;
  }

private:
  double height_;
};

/// Adds a range finder on the hand of every capture, whose reading is that of the joints as they are.
void addRangeFinders(const Eigen::Vector4d& offset, Measurements& measurements) {
  const Robot& robot = measurements.robot;
  const std::size_t hand = *robot.linkIndex("hand");
  measurements.levels.push_back({"range", ReadingLevel::Unit::metres, 0.001, true});
  for (ImageObservation& picture : measurements.pictures) {
    const RigidTransform there = forwardKinematics(robot, Eigen::VectorXd{picture.instant.q - offset})[hand];
    picture.witnesses.push_back({ObservationChain::betweenLinks(robot, measurements.quantities, hand, 0),
                                 std::make_shared<RangeFinder>(measurements.levels.size() - 1,
                                                               (there * Eigen::Vector3d{0.01, 0.02, 0.03}).z())});
  }
}

const Noise exactJoints{.encoder = 0, .pose = 0};
const Eigen::Vector4d offset{0, 0.03, 0.004, 0};

struct MeasuredArm {
  Robot robot = parseUrdf(armUrdf, "arm.urdf");
  Measurements measurements = buildMeasurements({measuredArm(robot, offset)}, robot);
};

/// The same arm, whose hand rolls by minus half of what lifts it: one motor drives both.
struct MimickingArm {
  static std::string urdf() {
    const std::string joint = R"(<axis xyz="0.6 0 0.8"/>)";
    return std::string{armUrdf}.replace(armUrdf.find(joint), joint.size(),
                                        joint + R"(<mimic joint="lift" multiplier="-0.5" offset="0.1"/>)");
  }
  Robot robot = parseUrdf(urdf(), "arm.urdf");
  const Eigen::Vector4d offset{0, 0.03, 0.004, -0.015};
  Measurements measurements = buildMeasurements({measuredArm(robot, offset, true)}, robot);
};

/// Where the initial estimate puts markers and places, zero for the rest.
Eigen::VectorXd startOf(const Measurements& measurements, const Model& model) {
  Eigen::VectorXd start = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.unknownCount()));
  for (const Term& term : model.terms()) {
    if (term.effect.placeKind == PlaceKind::marker) {
      const MarkerInstance& marker = measurements.instruments.markers[term.placeIndex];
      start.segment<3>(static_cast<Eigen::Index>(term.first)) = marker.start - marker.marker.pointGuess;
    } else if (term.effect.placeKind == PlaceKind::place) {
      start.segment<3>(static_cast<Eigen::Index>(term.first)) = measurements.instruments.places[term.placeIndex].start;
    }
  }
  return start;
}

/// Unknowns near those, none of them zero.
Eigen::VectorXd somewhere(const Measurements& measurements, const Model& model) {
  Eigen::VectorXd result = startOf(measurements, model);
  const Eigen::VectorXd sigmas = model.sigmas();
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    result[i] += 0.3 * std::min(sigmas[i], 0.02) * std::sin(static_cast<double>(1 + i));
  }
  return result;
}

/// Compares the gradient with fine differences of the cost.
void checkGradient(const Measurements& measurements, const Model& model, const Noise& noise,
                   const Eigen::VectorXd& here) {
  const Residuals residuals{measurements, model, noise};
  const Eigen::VectorXd sigmas = model.sigmas();
  const auto linear = residuals.linearize(residuals.startState(here));
  REQUIRE(linear);
  const auto cost = [&](const Eigen::VectorXd& unknowns) {
    return residuals.linearize(residuals.startState(unknowns))->cost;
  };
  for (Eigen::Index i = 0; i < here.size(); ++i) {
    INFO(model.names()[static_cast<std::size_t>(i)]);
    const auto central = [&](double step) {
      Eigen::VectorXd above = here, below = here;
      above[i] += step;
      below[i] -= step;
      return (cost(above) - cost(below)) / (2 * step);
    };
    const double step = 1e-2 * std::min(sigmas[i], 0.01), numeric = (4 * central(step / 2) - central(step)) / 3;
    const double scale = std::sqrt(linear->hessian(i, i) * 2 * linear->cost);
    CHECK(linear->gradient[i] == Approx(numeric).epsilon(1e-6).margin(1e-7 * scale));
  }
}

} // namespace

TEST_CASE("the cost of every kind of measurement changes with every unknown as its derivatives say") {
  // Compares the gradient for tracker points and frames, contacts, distances and a kind that only this test has with
  // fine differences, over offsets, all candidates of a robot with a URDF, and all placements: the chain from link to
  // world, each kind's own derivatives, the steps between links, the sums.
  MeasuredArm arm;
  addRangeFinders(Eigen::Vector4d::Zero(), arm.measurements);
  const Model model = buildModel(arm.measurements, {"linkGeometry@*", "lateralElasticity@lift", "trackerScale@vicon",
                                                    "motorCoupling@roll", "axisTilt@*", "elasticity@lift"});
  checkGradient(arm.measurements, model, exactJoints, somewhere(arm.measurements, model));
}

TEST_CASE("joints' zeros and all placements are found from readings of trackers, frames, contacts and distances") {
  // Proves on exact readings that the initial estimate leads the search to the truth, from a tracker whose attitude
  // locks roll and yaw, and that the result holds for a kind that was not fitted. The first joint's and the last one's
  // offsets are imitated by the tracker's and the marker's placements: they are zero here.
  MeasuredArm arm;
  const Model model = buildModel(arm.measurements);
  const Residuals residuals{arm.measurements, model, exactJoints};
  const auto found = levenbergMarquardt(residuals, residuals.startState(startOf(arm.measurements, model)));
  REQUIRE(found);
  CHECK(found->converged);
  const Term* const lift = model.find("jointOffset@lift");
  REQUIRE(lift);
  CHECK(found->state.unknowns[static_cast<Eigen::Index>(lift->first)] == Approx(offset[1]).margin(1e-4));
  const Term* const slide = model.find("jointOffset@slide");
  CHECK(found->state.unknowns[static_cast<Eigen::Index>(slide->first)] == Approx(offset[2]).margin(1e-4));
  addRangeFinders(offset, arm.measurements);
  const Residuals unseen{arm.measurements, model, exactJoints};
  double most = 0;
  for (const WitnessResidual& residual : unseen.witnessResiduals(unseen.startState(found->state.unknowns))) {
    most = std::max(most, residual.residual.cwiseAbs().maxCoeff());
  }
  CHECK(most < 1e-4);
}

TEST_CASE("a motor's effects turn the joint that mimics it by its ratio") {
  // Proves for every effect of a motor that the two joints keep their relation, that the cost changes with every
  // unknown as its derivatives say, and that the motor's zero is found from readings made of both joints' true angles.
  MimickingArm arm;
  const Model model = buildModel(arm.measurements,
                                 {"encoderGain@lift", "elasticity@lift", "encoderEccentricity@lift", "timeDrift@lift"});
  const Eigen::VectorXd here = somewhere(arm.measurements, model);
  const std::size_t lift = *arm.robot.jointIndex("lift"), roll = *arm.robot.jointIndex("roll");
  for (const ImageObservation& picture : arm.measurements.pictures) {
    const ModelState state = predictState(arm.measurements, model, picture, here);
    CHECK(std::abs(state.angle(lift) - picture.instant.q[eigenIndex(lift)]) > 1e-3);
    CHECK(state.angle(roll) == Approx(-0.5 * state.angle(lift) + 0.1).margin(1e-14));
  }
  checkGradient(arm.measurements, model, exactJoints, here);

  const Model plain = buildModel(arm.measurements);
  checkMinimizedGradient(Residuals{arm.measurements, plain, {.encoder = 1e-4, .pose = 1e-3}},
                         somewhere(arm.measurements, plain), plain.sigmas().cwiseMin(0.02), 1e-3);
  const Residuals residuals{arm.measurements, plain, exactJoints};
  const auto found = levenbergMarquardt(residuals, residuals.startState(startOf(arm.measurements, plain)));
  REQUIRE(found);
  const auto zero = [&](const char* label) {
    return found->state.unknowns[static_cast<Eigen::Index>(plain.find(label)->first)];
  };
  CHECK(zero("jointOffset@lift") == Approx(arm.offset[1]).margin(1e-4));
  CHECK(zero("jointOffset@slide") == Approx(arm.offset[2]).margin(1e-4));
  CHECK(plain.find("jointOffset@roll") == nullptr);
}

TEST_CASE("a reading along a joint that was not recorded is refused") {
  // Proves the sentence for a marker; a reading whose chain does not hold the joint would be used.
  const Robot robot = parseUrdf(armUrdf, "arm.urdf");
  CaptureSet set = measuredArm(robot, Eigen::Vector4d::Zero());
  set.captures[3].joints.measured[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(buildMeasurements({set}, robot),
                    Catch::Contains("capture 3") && Catch::Contains("lift") && Catch::Contains("not recorded"));
}

} // namespace naocal
