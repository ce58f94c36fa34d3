#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace CLI {
class Validator;
}

namespace naocal {

/// Format name of report pages; JSON files have the key `format`.
inline constexpr std::string_view pageFormat = "naocal's report page";

/// Throws InputError if a file holds another format, so that no command overwrites it. Files that do not exist, are
/// empty, or are not regular (pipes, devices) are accepted.
void requireSameKind(const std::filesystem::path& file, std::string_view format);

/// The same check for a command-line option that names an output file (- is standard output), before a long
/// computation.
CLI::Validator replaceableFile(std::string format);

/// Throws InputError if the folder holds a set that was not simulated. Removes what killed writers have left in it.
void requireReplaceableSet(const std::filesystem::path& folder);

/// Writes JSON to a file, or to standard output for "-". Throws InputError if the file holds another format.
void writeJson(const nlohmann::json& json, const std::string& file);

/// Writes a report page. Throws InputError if the file holds another format.
void writePage(const std::filesystem::path& file, const std::string& page);

} // namespace naocal
