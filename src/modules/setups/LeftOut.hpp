#pragma once

#include "data/Capture.hpp"

#include <string>
#include <vector>

namespace naocal {

/// Whether a label names what a person leaves out: "leftOut@capture:17", "leftOut@pose:P03", "leftOut@board:A"; of one
/// of several sets "leftOut@pose:SET/P03"; several with commas.
bool isLeftOut(const std::string& label);

/// The label that leaves out the capture of this name ("17", "SET/17").
std::string leaveOutLabel(const std::string& capture);

/// Takes away what it measured. The captures and their joint readings stay, as directions of approach come from their
/// order. Throws InputError where the sets have no such thing, or where nothing is left.
void leaveOut(const std::string& label, std::vector<CaptureSet>& sets);

} // namespace naocal
