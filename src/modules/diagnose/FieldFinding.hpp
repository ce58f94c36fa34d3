#pragma once

#include "diagnose/Diagnosis.hpp"
#include "diagnose/ImageFields.hpp"

namespace naocal {

/// A field within pictures as a curve, like those of joints.
/// It varies with, for a board its rows ("y") or columns ("x"), for a camera the picture's ("v", "u"). Of all
/// pairs of a component and a driver the one that varies most.
DriverFinding fieldFinding(const ImageField& field, const Measurements& measurements);

} // namespace naocal
