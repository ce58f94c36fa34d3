#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// Where a result's captures are looked for besides their places, and who is told where they were found or why the page
/// is without their pictures: one sentence per set.
struct CaptureSources {
  std::vector<std::filesystem::path> lookIn = {};
  std::function<void(const std::string& sentence)> tell = [](const std::string&) {};
};

/// Renders a result of 'naocal solve', a diagnosis of 'naocal diagnose' or an evaluation of 'naocal evaluate thesis' as
/// one self-contained HTML page: no network, no other file. A result page has the verdict, every estimate with its
/// error bar, and every corner's residual as figures; photographs and joint angles come from the captures if available.
/// A diagnosis page has the verdict, the errors of all models, every candidate, and the curves of joints. Throws
/// InputError for other files.
std::string renderReport(const std::filesystem::path& file, const CaptureSources& sources = {});
/// The same from a document that `file` would hold: captures are found beside it, and messages name it.
std::string renderReport(const nlohmann::json& document, const std::filesystem::path& file,
                         const CaptureSources& sources = {});

} // namespace naocal
