#pragma once

#include "diagnose/Diagnosis.hpp"

#include <functional>
#include <optional>

namespace naocal {

/// Where the fit is grossly off: a joint whose angles have the wrong sign, or cameras whose names are swapped, tried by
/// fitting the sets so corrected. Absent where the misfit is small or no such correction mends it.
/// `rmsPx`: of the fit as the sets are; infinite where none was possible [px]. `mayBeMirrored`: motors worth a fit.
std::optional<Suspicion> wrongSetUp(const std::vector<CaptureSet>& sets, const Measurements& measurements, double rmsPx,
                                    const std::function<bool(std::size_t)>& mayBeMirrored);

} // namespace naocal
