#include "hardware/simulated/SimulatedPlan.hpp"

namespace naocal {

RawAngles SimulatedPlan::standing() {
  RawAngles angles;
  const auto set = [&](std::string_view joint, double value) { angles[*jointNumber(joint)] = radians(value); };
  for (const std::string side : {"L", "R"}) {
    set(side + "ShoulderPitch", 85);
    set(side + "ShoulderRoll", side == "L" ? 8 : -8);
    set(side + "ElbowRoll", side == "L" ? -5 : 5);
    set(side + "HipPitch", -26);
    set(side + "KneePitch", 52);
    set(side + "AnklePitch", -26);
  }
  return angles;
}

SimulatedErrors drawnErrors(const Robot& drawing, const SimulatedPlan& plan) {
  Randomness errorChance{plan.seed, "errors"}, playChance{plan.seed, "play"};
  SimulatedErrors errors{drawnErrors(drawing, plan.offsetRange, plan.mountRange, plan.mountShiftRange, errorChance),
                         std::vector<double>(drawing.joints.size())};
  for (double& play : errors.play) {
    play = std::abs(playChance.within(plan.playRange));
  }
  for (std::size_t joint = 0; joint < drawing.joints.size(); ++joint) {
    errors.play[joint] = errors.play[drawing.joints[joint].motor];
  }
  return errors;
}

} // namespace naocal
