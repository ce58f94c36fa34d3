#pragma once

#include "calibration/result/CalibrationResult.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Offsets that another term imitates: first unknown -> that term.
using HeldOffsets = std::map<std::size_t, const Term*>;

/// Offsets of joints of a robot with a URDF that are not determined only because unknown placements, mounts of cameras
/// or the drawing's steps do what they do: with these known they would be. A joint that stands still has no such
/// offset.
HeldOffsets findHeldOffsets(const FittedModel& fitted);

/// Unknowns that were asked for and that the captures do not determine (`threshold::learned`), one finding per term
/// with advice:
///   - offsets, unless they are held; joints that stand still in one finding;
///   - rotations and translations of cameras and other effects, unless they are known together with other effects, for
///     which they can only be traded. Of an effect with several unknowns one suffices, as the others stay within what
///     is plausible; not of a camera's mount on a robot without URDF, whose unknown placements never imitate a mount.
std::vector<Finding> listUndetermined(const FittedModel& fitted, const HeldOffsets& held);

/// Joints that stand still, if their offsets were asked for and one of them is not learned, with advice.
std::optional<Finding> describeStillJoints(const FittedModel& fitted);

/// An offset's sigma with its unit: "5.7°", "3.1 mm".
std::string formatSigma(const Term& offset, double sigma);

} // namespace naocal
