#include "world/Flaws.hpp"

#include <algorithm>

namespace blind {

namespace {

using Values = std::span<const double>;

const std::vector<std::string> chainJoints{"HeadYaw",  "HeadPitch", "HipYawPitch", "HipRoll",
                                           "HipPitch", "KneePitch", "AnklePitch",  "AnkleRoll"};
const std::vector<std::string> loadedJoints{"HeadPitch", "HipRoll", "HipPitch", "KneePitch", "AnklePitch", "AnkleRoll"};
const std::vector<std::string> bothCameras{"top", "bottom"}, anyBoard{"board"}, anySole{"sole"};

/// A family whose unknowns are members of JointFlaws.
FlawFamily ofJoint(std::string effect, std::vector<FlawFamily::Unknown> unknowns, std::vector<std::string> places,
                   std::vector<double JointFlaws::*> members, std::vector<double> factors = {1, 1}) {
  return {std::move(effect),
          std::move(unknowns),
          std::move(places),
          [members, factors](Flaws& flaws, const Drawing& drawing, const std::string& place, Values values) {
            JointFlaws& joint = flaws.joints[drawing.joint(place)];
            for (std::size_t i = 0; i < members.size(); ++i) {
              joint.*members[i] += factors[i] * values[i];
            }
          },
          {}};
}

template <typename Apply>
FlawFamily ofCamera(std::string effect, std::vector<FlawFamily::Unknown> unknowns, Apply apply) {
  return {std::move(effect),
          std::move(unknowns),
          bothCameras,
          [apply](Flaws& flaws, const Drawing&, const std::string& place, Values values) {
            apply(flaws.cameras[place == "top" ? 0 : 1], values);
          },
          {}};
}

template <typename Apply>
FlawFamily ofBoard(std::string effect, std::vector<FlawFamily::Unknown> unknowns, Apply apply) {
  return {std::move(effect),
          std::move(unknowns),
          anyBoard,
          [apply](Flaws& flaws, const Drawing&, const std::string& place, Values values) {
            apply(flaws.boards[place.front() - 'A'], values);
          },
          {}};
}

template <typename Apply>
FlawFamily ofSole(std::string effect, std::vector<FlawFamily::Unknown> unknowns, Apply apply) {
  return {std::move(effect),
          std::move(unknowns),
          anySole,
          [apply](Flaws& flaws, const Drawing&, const std::string& place, Values values) {
            apply(flaws.soles[place == "left" ? 0 : 1], values);
          },
          {}};
}

std::vector<FlawFamily> makeCatalogue() {
  using J = JointFlaws;
  return {
      ofJoint("backlash", {{"D", "rad", 0.006, 0.01}}, loadedJoints, {&J::gap}),
      ofJoint("hysteresis", {{"D", "rad", 0.006, 0.01}}, chainJoints, {&J::lag}),
      {"gearPlay",
       {{"D", "rad", 0.006, 0.01}},
       loadedJoints,
       [](Flaws& flaws, const Drawing& drawing, const std::string& place, Values values) {
         JointFlaws& joint = flaws.joints[drawing.joint(place)];
         joint.gap += values[0];
         joint.gapFriction = joint.stickiness;
       },
       {}},
      ofJoint("elasticity", {{"c", "rad/Nm", 0.003, 0.01}}, loadedJoints, {&J::compliance}),
      ofJoint("encoderGain", {{"g", "1", 0.01}}, chainJoints, {&J::gain}),
      ofJoint("encoderEccentricity", {{"a", "rad", 0.008, 0.005}, {"b", "rad", 0.008, 0.005}}, chainJoints,
              {&J::magnetX, &J::magnetY}, {1, -1}),
      ofJoint("thermalDrift", {{"k", "rad/K", 3e-4, 5e-4}}, chainJoints, {&J::warming}),
      ofJoint("timeDrift", {{"k", "rad/s", 2e-5, 1e-5}}, chainJoints, {&J::creep}),
      ofJoint("axisTilt", {{"alpha", "rad", 0.012}, {"beta", "rad", 0.012}}, chainJoints,
              {&J::tiltAlpha, &J::tiltBeta}),
      {"timeOffset",
       {{"dt", "s", 0.02}},
       {"all"},
       [](Flaws& flaws, const Drawing&, const std::string&, Values values) { flaws.delay += values[0]; },
       {}},
      {"linkLength",
       {{"dL", "m", 0.002}},
       {"neckZ", "hipZ", "hipY", "thigh", "tibia", "footZ"},
       [](Flaws& flaws, const Drawing&, const std::string& place, Values values) { flaws.lengths[place] += values[0]; },
       {}},
      ofCamera("cameraTranslation", {{"x", "m", 0.003, 0.005}, {"y", "m", 0.003, 0.005}, {"z", "m", 0.003, 0.005}},
               [](CameraFlaws& camera, Values v) {
                 camera.shift += Eigen::Vector3d{v[0], v[1], v[2]};
               }),
      ofCamera("focalLength", {{"s", "1", 0.01, 0.03}}, [](CameraFlaws& camera, Values v) { camera.focal += v[0]; }),
      ofCamera("principalPoint", {{"x", "px", 5, 20}, {"y", "px", 5, 20}},
               [](CameraFlaws& camera, Values v) {
                 camera.principal += Eigen::Vector2d{v[0], v[1]};
               }),
      ofCamera("radialDistortion", {{"k1", "1", 0.04, 0.1}, {"k2", "1", 0.04, 0.2}},
               [](CameraFlaws& camera, Values v) { camera.k1 += v[0], camera.k2 += v[1]; }),
      ofCamera("tangentialDistortion", {{"p1", "1", 0.003, 0.01}, {"p2", "1", 0.003, 0.01}},
               [](CameraFlaws& camera, Values v) { camera.p1 += v[0], camera.p2 += v[1]; }),
      ofCamera("rollingShutter", {{"s", "s/row", 6e-5}}, [](CameraFlaws& camera, Values v) { camera.rowTime += v[0]; }),
      ofBoard("boardScale", {{"s", "1", 0.006, 0.01}}, [](BoardFlaws& board, Values v) { board.scale += v[0]; }),
      ofBoard("boardBow", {{"h", "m", 0.004}}, [](BoardFlaws& board, Values v) { board.bow += v[0]; }),
      ofBoard("boardTilt", {{"roll", "rad", 0.01}, {"pitch", "rad", 0.01}},
              [](BoardFlaws& board, Values v) { board.roll += v[0], board.pitch += v[1]; }),
      ofSole("soleCompliance", {{"c", "rad/m", 0.15, 0.3}}, [](SoleFlaws& sole, Values v) { sole.compliance += v[0]; }),
      ofSole("soleTilt", {{"roll", "rad", 0.02}, {"pitch", "rad", 0.02}},
             [](SoleFlaws& sole, Values v) { sole.roll += v[0], sole.pitch += v[1]; }),
  };
}

/// Letter of a leg joint's side, otherwise empty.
std::string sideOf(const std::string& place) {
  return place.starts_with("Head") ? "" : place.substr(0, 1);
}

std::vector<FlawFamily> makeOutside() {
  using J = JointFlaws;
  constexpr double size = 0.3 * 3.14159265358979 / 180; // [rad]
  const auto named = [](FlawFamily family, std::vector<std::string> drivers) {
    family.drivers = std::move(drivers);
    return family;
  };
  const auto pulled = [](const std::string& puller, double J::*member) {
    return [puller, member](Flaws& flaws, const Drawing& drawing, const std::string& place, Values values) {
      JointFlaws& joint = flaws.joints[drawing.joint(place)];
      joint.puller = drawing.joint(puller.starts_with("Head") ? puller : sideOf(place) + puller);
      joint.*member += values[0];
    };
  };
  return {
      named(ofJoint("kneeRipple", {{"amplitude", "rad", size}}, {"KneePitch"}, {&J::ripple}), {"q"}),
      {"hipPullsKnee", {{"slope", "1", size / 0.6}}, {"KneePitch"}, pulled("HipPitch", &J::pulled), {"HipPitch"}},
      named(ofJoint("ankleSlip", {{"step", "rad", size}}, {"AnklePitch"}, {&J::slip}), {"t"}),
      named(ofJoint("kneeRootSag", {{"size", "rad/sqrt(Nm)", size / 1.4}}, {"KneePitch"}, {&J::rootSag}), {"tau"}),
      {"yawNods", {{"slope", "1", size / 1.2}}, {"HeadPitch"}, pulled("HeadYaw", &J::pulledByMagnitude), {"HeadYaw"}},
      named(ofCamera("mountDrift", {{"rate", "rad/s", size / 400}},
                     [](CameraFlaws& camera, Values v) { camera.turning += v[0]; }),
            {"t"}),
  };
}

} // namespace

const std::vector<FlawFamily>& catalogue() {
  static const std::vector<FlawFamily> families = makeCatalogue();
  return families;
}

const FlawFamily& offsetStep() {
  static const FlawFamily family =
      ofJoint("offsetStep", {{"step", "rad", 0.01}}, chainJoints, {&JointFlaws::slip}); // half a degree
  return family;
}

const std::vector<std::string>& cameraFamilies() {
  static const std::vector<std::string> names{"cameraTranslation", "focalLength", "principalPoint", "radialDistortion"};
  return names;
}

const std::vector<FlawFamily>& offCatalogue() {
  static const std::vector<FlawFamily> families = makeOutside();
  return families;
}

std::vector<std::string> placesFor(const FlawFamily& family, int side, std::size_t boards) {
  std::vector<std::string> places;
  for (const std::string& place : family.places) {
    if (place == "board") {
      for (std::size_t board = 0; board < boards; ++board) {
        places.emplace_back(1, static_cast<char>('A' + board));
      }
    } else if (place == "sole") {
      places.emplace_back(side == 0 ? "left" : "right");
    } else if (place == "HipYawPitch" && family.effect != "axisTilt") {
      places.emplace_back("LHipYawPitch"); // one motor
    } else if (place.ends_with("Pitch") || place.ends_with("Roll")) {
      places.push_back(place.starts_with("Head") ? place : (side == 0 ? "L" : "R") + place);
    } else {
      places.push_back(place);
    }
  }
  return places;
}

} // namespace blind
