#pragma once

#include "calibration/Calibration.hpp"

#include <string>
#include <vector>

namespace naocal {

/// Mean excess of a joint's encoder reading over the modelled angle: offset o plus the corrections of the model's other
/// effects, averaged over the pictures in which the joint lies between board and camera. A constant offset can
/// compensate this much.
struct EffectiveOffset {
  std::string joint;
  double value = 0, sigma = 0; // mean and standard error [rad]
  double learned = 0;          // of o: 1 - posterior sigma / prior sigma
};

/// One entry per measured joint whose offset is in the model.
std::vector<EffectiveOffset> effectiveOffsets(const FittedModel& fitted);

/// A joint's offset o, and the sum delta of the corrections of the model's other effects: the true angle is the reading
/// - o + delta. At one posture the constant o - delta compensates both; elsewhere it is off by the change of delta.
struct JointCompensation {
  std::string joint;
  double offset = 0;              // o [rad]
  double delta = 0;               // at the posture [rad]
  double mean = 0, spread = 0;    // mean and standard deviation of delta over the pictures with a board [rad]
  double lowest = 0, highest = 0; // of delta over the pictures [rad]
  double constant() const { return offset - delta; }
};

/// The compensation at a posture (one true angle per joint [rad]) on both feet, at rest, without a last direction of
/// motion, at the mean temperatures, currents and time of the pictures: one entry per joint with an offset in the
/// model. Requires a picture with a board.
std::vector<JointCompensation> jointCompensations(const Measurements& measurements, const Model& model,
                                                  const Eigen::VectorXd& unknowns, const Eigen::VectorXd& posture);

/// Whether the captures determine the offset (`threshold::learned`). If not, the robot should keep its present value.
bool isLearned(const EffectiveOffset& offset);

} // namespace naocal
