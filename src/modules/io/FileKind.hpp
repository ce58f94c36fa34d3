#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace naocal {

/// Format name of report pages; JSON files have the key `format`.
inline constexpr std::string_view pageFormat = "naocal's report page";

/// Throws InputError if a file holds another format, so that nothing overwrites it. Files that do not exist, are empty,
/// or are not regular (pipes, devices) are accepted.
void requireSameKind(const std::filesystem::path& file, std::string_view format);

/// Writes JSON with the key `format` atomically. Throws InputError if the file holds another format.
void replaceJson(const std::filesystem::path& file, const nlohmann::json& json);

} // namespace naocal
