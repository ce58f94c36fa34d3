#pragma once

#include "CommandText.hpp"

namespace naocal::manual {

/// The completion of a program for fish.
std::string fishCompletion(const Command& program, const std::vector<EffectPlaces>& effects);

} // namespace naocal::manual
