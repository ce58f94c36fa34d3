#pragma once

#include "calibration/result/CalibrationResult.hpp"
#include "estimation/Model.hpp"
#include "measurements/Noise.hpp"

#include <string>
#include <vector>

namespace naocal {

/// An unknown in words: "the left hip pitch" for jointOffset@LHipPitch.o, "the top camera's pitch" for
/// cameraRotation@top.ry, "board A's bow" for boardBow@A.h.
std::string describeUnknown(const Term& term, std::size_t unknown);
/// "LKneePitch" for its offset, which stands for the joint; else effect, place and unknown.
std::string nameUnknown(const Term& term, std::size_t unknown);
/// What explanations add, in words: "elasticity@LKneePitch", "a curve of LKneePitch over q", "a motion of Torso".
std::vector<std::string> describeMissing(const std::vector<std::string>& labels);
/// A term that can imitate a joint's offset, an unknown placement or a link geometry: "where tracker vicon stands".
std::string describeImitator(const Term& term);

/// An unlikely explanation that would move an estimate far, and how far it may be off then; empty without one:
/// "LKneePitch may be -1.90° (3 %) if elasticity@LKneePitch is missing; 99.95 % bound -2.05° to 0.31°". Where it makes
/// the estimate uncertain instead: "LKneePitch may lie from -2.05° to 0.31° (99.95 %) if ...". `unit`: of the unknown,
/// SI.
std::string formatShoulder(const std::string& name, const std::string& unit, const Averaged& averaged);

/// Noise of encoders and joints, 1 sigma: "encoders 0.0250°, joint scatter 0.0123° from pose to pose and 0.0100° from
/// stance to stance". `hasUnknownSteps`: an encoder's noise is part of the scatter (`Measurements::hasUnknownSteps`).
std::string formatJointNoise(const Noise& noise, bool hasUnknownSteps);

/// Whether the captures tell an unknown's size: standard error below `threshold::undetermined` prior sigmas.
bool isTold(const Unknown& unknown, double variance);
/// Sizes of an effect with their standard errors: "c = 0.31 ± 0.02 °/Nm".
std::string formatSizes(const Effect& effect, const Eigen::VectorXd& estimate, const Eigen::MatrixXd& covariance);
/// For example "12 of 7654 corners do not fit the rest".
std::string formatRejected(const RejectedMeasurements& rejected);
/// That an effect is beyond chance, but too small to matter; its displacement in `unit`.
std::string formatNegligible(const NegligibleEffect& effect, const ErrorUnit& unit);

/// "a", "a and b", "a, b and c".
std::string joinWords(const std::vector<std::string>& words);

} // namespace naocal
