#pragma once

#include "CommandText.hpp"

namespace naocal::manual {

/// The completion of a program for bash; it needs no other file.
std::string bashCompletion(const Command& program, const std::vector<EffectPlaces>& effects);

} // namespace naocal::manual
