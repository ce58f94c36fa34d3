#pragma once

#include "CommandText.hpp"

namespace naocal::manual {

/// The completion of a program for zsh, a file of its $fpath.
std::string zshCompletion(const Command& program, const std::vector<EffectPlaces>& effects);

} // namespace naocal::manual
