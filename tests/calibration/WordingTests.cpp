#include "calibration/result/Wording.hpp"
#include "effects/Catalogue.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

std::string spoken(Effect effect, const std::string& place, std::size_t unknown = 0) {
  return describeUnknown(Term{.effect = std::move(effect), .placeName = place}, unknown);
}

} // namespace

TEST_CASE("unknowns are named as a person would name them") {
  // Proves the wording of nine unknowns, one of them at a board; other effects are not covered.
  CHECK(spoken(jointOffset(), "LKneePitch") == "the left knee pitch");
  CHECK(spoken(jointOffset(), "RElbowYaw") == "the right elbow yaw");
  CHECK(spoken(jointOffset(), "HeadYaw") == "the head yaw");
  CHECK(spoken(cameraRotation(), "top", 1) == "the top camera's pitch");
  CHECK(spoken(cameraTranslation(), "bottom", 2) == "the bottom camera's place (up)");
  CHECK(spoken(focalLength(), "top") == "the top camera's focal length");
  CHECK(spoken(radialDistortion(), "top", 1) == "the top camera's radial distortion (k2)");
  CHECK(spoken({.name = "boardBow", .placeKind = PlaceKind::board, .unknowns = {{"h", "m", 0.002}}}, "A") ==
        "board A's bow");
  CHECK(spoken({.name = "encoderGain", .unknowns = {{"g", "1", 0.01}}}, "HeadPitch") ==
        "the head pitch's encoder gain");
}

TEST_CASE("noise of encoders is said only where their steps are known") {
  // Proves the words for a NAO's encoders with and without scatter between stances, and for encoders of unknown steps.
  Noise noise{.encoder = 0.0005, .pose = 0.0002};
  CHECK(formatJointNoise(noise, false) == "encoders 0.0286°, joint scatter 0.0115° from pose to pose");
  noise.stance = 0.001;
  CHECK(formatJointNoise(noise, false).ends_with("0.0115° from pose to pose and 0.0573° from stance to stance"));
  noise.stance = 0;
  CHECK(formatJointNoise(noise, true) ==
        "encoders' steps unknown, their noise part of the joint scatter 0.0115° from pose to pose");
}

TEST_CASE("several names are joined as in a sentence") {
  // Proves the commas and the last "and".
  CHECK(joinWords({}).empty());
  CHECK(joinWords({"a"}) == "a");
  CHECK(joinWords({"a", "b"}) == "a and b");
  CHECK(joinWords({"a", "b", "c"}) == "a, b and c");
}

TEST_CASE("an unlikely explanation is said with the value that it has, or the range that it leaves") {
  // Proves units, decimals of the standard error, and both forms; nothing is said without such an explanation.
  Averaged averaged{.value = 0.01, .sigma = 0.002, .bound = {-0.03, 0.02}};
  CHECK(formatShoulder("LKneePitch", "rad", averaged).empty());
  averaged.shoulder = Shoulder{{"elasticity@LKneePitch"}, {}, 0.03, -0.02};
  CHECK(formatShoulder("LKneePitch", "rad", averaged) ==
        "LKneePitch may be -1.15° (3 %) if elasticity@LKneePitch is missing; 99.95 % bound -1.72° to 1.15°");
  averaged.shoulder = Shoulder{{"a@b", "c@d"}, {"e@f"}, 0.0004, 0.011};
  CHECK(formatShoulder("slide", "m", averaged) ==
        "slide may lie from -30.0 mm to 20.0 mm (99.95 %) if a@b and c@d are missing and e@f is not there (0.04 %)");
  averaged.shoulder = Shoulder{{"LKneePitch over q"}, {}, 0.0004, 0.011};
  CHECK(formatShoulder("slide", "m", averaged) ==
        "slide may lie from -30.0 mm to 20.0 mm (99.95 %) if a curve of LKneePitch over q is missing (0.04 %)");
  averaged.shoulder = Shoulder{{}, {"e@f"}, 0.0004, 0.011};
  CHECK(formatShoulder("slide", "m", averaged) ==
        "slide may lie from -30.0 mm to 20.0 mm (99.95 %) if e@f is not there (0.04 %)");
}

} // namespace naocal
