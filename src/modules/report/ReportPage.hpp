#pragma once

#include <filesystem>
#include <string>

namespace naocal {

/// A result of 'naocal solve' or a diagnosis of 'naocal diagnose' as one HTML page that needs nothing else: no network,
/// no other file. Of a result it holds the verdict, every estimate with its error bar, and every corner's residual as
/// figures; photographs and joint angles are taken from the captures where those are still there. Of a diagnosis it
/// holds the verdict, the ladder of errors, every candidate, and the curves that joints follow. Throws InputError for
/// what is neither.
std::string renderReport(const std::filesystem::path& file);

} // namespace naocal
