#pragma once

#include "residuals/Measurements.hpp"
#include "residuals/Model.hpp"

namespace naocal {

/// Adds where boards lie and feet stand, as far as pictures depend on it and no survey says it. On the floor: x, y,
/// yaw; on a link: all six, or three for a single mark. Their widths: the set's own (`placementSigma`), else
/// "anywhere".
void addPlacements(const Measurements& measurements, Model& model);

} // namespace naocal
