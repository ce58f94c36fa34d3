#pragma once

#include <filesystem>
#include <string>

namespace naocal {

/// A result of 'naocal solve' as one HTML page that needs nothing else: no network, no other file. It holds the
/// verdict, every estimate with its error bar, and every corner's residual as figures. Photographs and joint angles
/// are taken from the captures where those are still there. Throws InputError for what is not a result file.
std::string reportPage(const std::filesystem::path& resultFile);

} // namespace naocal
