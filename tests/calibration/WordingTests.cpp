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

} // namespace naocal
