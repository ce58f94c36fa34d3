#include "estimation/ModelBuilder.hpp"
#include "estimation/Residuals.hpp"
#include "math/LevenbergMarquardt.hpp"
#include "math/LinearAlgebra.hpp"
#include "robot/Urdf.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fmt/format.h>

namespace naocal {
namespace {

constexpr double thigh = 0.3, leftShank = 0.3, rightShank = 0.28;

/// A pelvis on two legs of three joints that turn about y; the feet's frames lie on the floor.
std::string bipedUrdf() {
  std::string text = R"(<robot name="biped"><link name="pelvis"/>)";
  const auto add = [&](const std::string& parent, const std::string& child, const std::string& joint, double y,
                       double z) {
    text += fmt::format(R"(<link name="{1}"/><joint name="{2}" type="revolute"><parent link="{0}"/><child link="{1}"/>)"
                        R"(<origin xyz="0 {3} {4}"/><axis xyz="0 1 0"/>)"
                        R"(<limit lower="-3" upper="3" velocity="1" effort="1"/></joint>)",
                        parent, child, joint, y, z);
  };
  for (const std::string side : {"l", "r"}) {
    add("pelvis", side + "_thigh", side + "_hip", side == "l" ? 0.1 : -0.1, 0);
    add(side + "_thigh", side + "_shank", side + "_knee", 0, -thigh);
    add(side + "_shank", side + "_foot", side + "_ankle", 0, side == "l" ? -leftShank : -rightShank);
  }
  return text + "</robot>";
}

/// Angles of a leg whose thigh and shank lean by these angles over a level foot.
Eigen::Vector3d legAngles(double ofThigh, double ofShank) {
  return {ofThigh, ofShank - ofThigh, -ofShank};
}

/// Readings of the biped on both feet, whose joints' zeros are off by `offset`. A tracker sees the pelvis, so that
/// only the contact of the right foot tells of the right leg.
CaptureSet bipedOnBothFeet(const Eigen::Matrix<double, 6, 1>& offset) {
  CaptureSet set;
  set.name = "biped";
  set.version = 2;
  set.model.clear();
  set.urdf = "biped.urdf";
  set.jointNames = {"l_hip", "l_knee", "l_ankle", "r_hip", "r_knee", "r_ankle"};
  set.instruments.trackers = {{"vicon", 0.0001, 0.0001, Placement{}}};
  set.instruments.frames = {{"badge", "pelvis", Placement{}}};
  set.stances = {
      {.id = 0, .supportFoot = SupportFoot::none, .placement = Placement{}, .supportLinks = {"l_foot", "r_foot"}}};
  for (int i = 0; i < 12; ++i) {
    const double left = -0.3 - 0.05 * i, leftLower = 0.4 + 0.03 * (i % 5), right = -0.2 - 0.04 * (i % 7);
    const double height = thigh * std::cos(left) + leftShank * std::cos(leftLower);
    const double rightLower = std::acos((height - thigh * std::cos(right)) / rightShank);
    Eigen::Matrix<double, 6, 1> angles;
    angles << legAngles(left, leftLower), legAngles(right, rightLower);
    const Eigen::Matrix<double, 6, 1> read = angles + offset;
    Capture capture{.id = i, .pose = "P" + std::to_string(i), .time = Seconds{i}};
    capture.supportFoot = SupportFoot::none;
    capture.joints.measured.assign(read.begin(), read.end());
    const Eigen::Vector3d pelvis{thigh * std::sin(left) + leftShank * std::sin(leftLower), -0.1, height};
    capture.frames = {{"vicon", "badge", pelvis, Eigen::Quaterniond::Identity()}};
    set.captures.push_back(std::move(capture));
  }
  return set;
}

} // namespace

TEST_CASE("a second sole on the floor tells the zeros of its leg") {
  // Proves on readings from closed forms that each pose has three numbers more, that their derivatives are those of
  // the cost, and that the zeros of the leg which nothing else measures are found, except where that leg was not read.
  const Eigen::Matrix<double, 6, 1> offset{0.02, -0.01, 0.015, -0.03, 0.02, 0.01};
  const Robot robot = parseUrdf(bipedUrdf(), "biped.urdf");
  CaptureSet set = bipedOnBothFeet(offset);
  const Measurements measurements = buildMeasurements({set}, robot);
  for (const PoseGroup& pose : measurements.poses) {
    CHECK(measurements.pictures[pose.readings.front().pictures.front()].otherSoles.size() == 1);
  }
  const Model model = buildModel(measurements);
  const Noise exactJoints{.encoder = 0, .pose = 0};
  const Residuals residuals{measurements, model, exactJoints};
  const auto found =
      levenbergMarquardt(residuals, residuals.startState(Eigen::VectorXd::Zero(eigenIndex(model.unknownCount()))));
  REQUIRE(found);
  CHECK(found->converged);
  for (std::size_t joint = 0; joint < set.jointNames.size(); ++joint) {
    CAPTURE(set.jointNames[joint]);
    const Term* const term = model.find("jointOffset@" + set.jointNames[joint]);
    REQUIRE(term);
    CHECK(found->state.unknowns[eigenIndex(term->first)] == Approx(offset[eigenIndex(joint)]).margin(1e-3));
  }

  CaptureSet unread = set;
  unread.captures.front().joints.measured[4] = std::nan("");
  const Measurements partly = buildMeasurements({unread}, robot);
  std::size_t contacts = 0;
  for (const ImageObservation& picture : partly.pictures) {
    contacts += picture.otherSoles.size();
  }
  CHECK(contacts == set.captures.size() - 1); // a leg that was not read says nothing about its foot

  set.stances.front().supportLinks.pop_back();
  const Measurements onOne = buildMeasurements({set}, robot);
  CHECK(buildModel(onOne).find("jointOffset@r_knee") == nullptr);
}

} // namespace naocal
