#pragma once

#include "calibration/result/ResultFile.hpp"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace naocal {

/// That an offset or a camera's turn is beyond what any robot is wrong by, in one sentence; absent if it is not.
/// Offsets beyond `threshold::farthestTurn` or `farthestSlide`; turns beyond `farthestTurn` and `farthestSigmas` prior
/// sigmas.
std::optional<std::string> describeImplausible(const Term& term, std::span<const double> values);

/// That the rms errors of a fit are beyond what any robot has: `threshold::impossiblePx`, as an angle through longer
/// lenses, or `impossibleMetres` and `impossibleRadians` (and `impossibleNoises` times a noise that is given).
/// Displaced boards do not count, and other rejected measurements only from a share of `threshold::manyRejected` on.
/// Absent if they are not.
std::optional<std::string> describeImpossibleError(const FittedModel& fitted);

/// Errors, noise and values of a fit that are beyond what any robot has:
///   - errors as of `describeImpossibleError`;
///   - estimated noise of readings beyond `threshold::grossMetres` or `grossRadians`, which hides any misfit;
///   - implausible values, as fitted or averaged.
std::vector<Finding> listImpossible(const FittedModel& fitted);

/// Implausible values among numbers of any source, by unknown: "jointOffset@LKneePitch.o" -> [rad].
std::vector<std::string> listImplausible(const std::map<std::string, double>& values);

/// Why a result must not be written to a robot, one sentence each: its own reasons, and of a usable one implausible
/// values and, where its version did not judge them, cameras whose rotation its captures do not tell. Empty: nothing
/// speaks against it.
std::vector<std::string> listReasonsAgainstUse(const StoredResult& result);

} // namespace naocal
