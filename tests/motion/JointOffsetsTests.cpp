#include "MotionRig.hpp"
#include "motion/JointOffsets.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <type_traits>

namespace naocal {
namespace {

template <class From, class To>
constexpr bool converts = std::is_constructible_v<To, From> || std::is_assignable_v<To&, From>;
static_assert(!converts<RawAngles, CompensatedAngles> && !converts<CompensatedAngles, RawAngles>,
              "raw and compensated angles must not be mixed");

} // namespace

TEST_CASE("what is sent to the motors is read back as what was desired") {
  // Proves raw = desired + offset and compensated = raw - offset, for random offsets and poses within the limits,
  // including unequal hip yaw-pitches.
  const Robot& robot = v6();
  const JointLimits limits{robot};
  std::mt19937 random{1};
  std::uniform_real_distribution<double> small{-radians(5), radians(5)};
  for (int i = 0; i < 100; ++i) {
    JointOffsets offsets;
    CompensatedAngles desired;
    for (std::size_t joint = 0; joint < jointCount; ++joint) {
      const bool isHand = limits.maxSpeed(joint) == 0;
      offsets.values[joint] = isHand ? 0 : small(random);
      desired[joint] = isHand ? 0.5 : small(random);
    }
    offsets.values[rightHip] = offsets.values[leftHip];
    for (const auto& [bent, degrees] : // their ranges end near 0
         std::map<const char*, double>{
             {"LElbowRoll", -40}, {"RElbowRoll", 40}, {"LKneePitch", 40}, {"RKneePitch", 40}}) {
      desired[*jointIndex(bent)] += radians(degrees);
    }
    const RawAngles raw = toMotorAngles(desired, offsets, limits);
    coupleHipYawPitch(desired);
    CHECK(raw[leftHip] == raw[rightHip]);
    const CompensatedAngles back = compensate(raw, offsets);
    for (std::size_t joint = 0; joint < jointCount; ++joint) {
      CHECK(raw[joint] == Approx(desired[joint] + offsets.values[joint]).margin(1e-12));
      CHECK(back[joint] == Approx(desired[joint]).margin(1e-12));
    }
  }
}

TEST_CASE("no joint is sent beyond its limits, whatever is desired and whatever its offset") {
  // Proves it for arbitrary desired angles, including limits that depend on another joint (ankle roll on ankle pitch).
  const Robot& robot = v6();
  const JointLimits limits{robot};
  std::mt19937 random{1};
  std::uniform_real_distribution<double> anywhere{-3, 3}, offset{-radians(10), radians(10)};
  for (int i = 0; i < 200; ++i) {
    CompensatedAngles desired;
    JointOffsets offsets;
    for (std::size_t joint = 0; joint < jointCount; ++joint) {
      desired[joint] = anywhere(random);
      offsets.values[joint] = offset(random);
    }
    const RawAngles raw = toMotorAngles(desired, offsets, limits);
    Eigen::VectorXd angles(static_cast<Eigen::Index>(robot.joints.size()));
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      angles[static_cast<Eigen::Index>(j)] = raw[*jointIndex(robot.joints[j].name)];
    }
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      const AngleRange range = jointLimitsAt(robot, j, angles);
      CAPTURE(robot.joints[j].name);
      CHECK(angles[static_cast<Eigen::Index>(j)] >= range.lower);
      CHECK(angles[static_cast<Eigen::Index>(j)] <= range.upper);
    }
    CHECK((raw[*jointIndex("LHand")] >= 0 && raw[*jointIndex("LHand")] <= 1));
  }
}

} // namespace naocal
