#pragma once

#include "diagnose/Diagnosis.hpp"

namespace naocal {

/// The map of a question, and those of its curves that explain most as findings.
void addMap(const Inquiry& inquiry, const Measurements& measurements, Diagnosis& diagnosis);

} // namespace naocal
