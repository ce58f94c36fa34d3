#include "world/machines/MachineFlaws.hpp"

namespace blind {

namespace {

using Values = std::span<const double>;

/// A family whose unknowns are members of JointFlaws.
MachineFamily ofJoint(std::string effect, std::vector<FlawFamily::Unknown> unknowns,
                      std::vector<double JointFlaws::*> members, bool positive = false) {
  return {std::move(effect), std::move(unknowns), positive,
          [members](MachineFlaws& flaws, std::size_t joint, Values values) {
            for (std::size_t i = 0; i < members.size(); ++i) {
              flaws.joints[joint].*members[i] += values[i];
            }
          }};
}

template <typename Apply>
MachineFamily ofLink(std::string effect, std::vector<FlawFamily::Unknown> unknowns, bool positive, Apply apply) {
  return {std::move(effect), std::move(unknowns), positive,
          [apply](MachineFlaws& flaws, std::size_t joint, Values values) { apply(flaws.links[joint], values); }};
}

std::vector<MachineFamily> makeFamilies() {
  using J = JointFlaws;
  using Link = MachineFlaws::Link;
  std::vector<MachineFamily> families{
      ofJoint("elasticity", {{"c", "rad/Nm", 0.0005}}, {&J::compliance}, true),
      ofJoint("encoderGain", {{"g", "1", 0.003}}, {&J::gain}),
      {"encoderEccentricity",
       {{"a", "rad", 0.003}, {"b", "rad", 0.003}},
       false,
       [](MachineFlaws& flaws, std::size_t joint, Values values) { // + a sin q + b cos q
         flaws.joints[joint].magnetX += values[0];
         flaws.joints[joint].magnetY -= values[1];
       }},
      ofJoint("axisTilt", {{"alpha", "rad", 0.004}, {"beta", "rad", 0.004}}, {&J::tiltAlpha, &J::tiltBeta}),
      ofJoint("timeDrift", {{"k", "rad/s", 5e-6}}, {&J::creep}),
      ofJoint("hysteresis", {{"D", "rad", 0.004}}, {&J::lag}, true),
      ofJoint("backlash", {{"D", "rad", 0.004}}, {&J::gap}, true),
      ofLink("linkGeometry",
             {{"x", "m", 0.002},
              {"y", "m", 0.002},
              {"z", "m", 0.002},
              {"rx", "rad", 0.005},
              {"ry", "rad", 0.005},
              {"rz", "rad", 0.005}},
             false,
             [](Link& link, Values values) {
               link.shift += Eigen::Vector3d{values[0], values[1], values[2]};
               link.turn += Eigen::Vector3d{values[3], values[4], values[5]};
             }),
      ofLink("lateralElasticity", {{"c1", "rad/Nm", 0.0005}, {"c2", "rad/Nm", 0.0005}}, true,
             [](Link& link, Values values) {
               link.bearing += Eigen::Vector2d{values[0], values[1]};
             }),
      ofLink("motorCoupling", {{"k", "1", 0.003}}, false,
             [](Link& link, Values values) { link.coupling += values[0]; }),
      {"trackerScale",
       {{"s", "1", 0.001}},
       false,
       [](MachineFlaws& flaws, std::size_t, Values values) { flaws.trackerScale += values[0]; },
       true}};
  return families;
}

} // namespace

const std::vector<MachineFamily>& machineCatalogue() {
  static const std::vector<MachineFamily> families = makeFamilies();
  return families;
}

} // namespace blind
