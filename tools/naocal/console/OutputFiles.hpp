#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace CLI {
class Validator;
}

namespace naocal {

/// What a page of a report counts as, where others are JSON files by their key `format`.
inline constexpr std::string_view pageFormat = "naocal's report page";

/// Throws InputError for a file that holds something else than the given format, which a command would destroy by
/// writing there. What does not exist, is empty, or has no content of its own (a pipe, a device) may be written to.
void requireSameKind(const std::filesystem::path& file, std::string_view format);

/// The same for an option that names a file to write (- is standard output): before a long computation, not after it.
CLI::Validator replaceableFile(std::string format);

/// Only a set that was simulated, or none, may be written over unasked; throws InputError.
void requireReplaceableSet(const std::filesystem::path& folder);

/// Writes JSON to a file, or to standard output for "-". Throws InputError for a file that holds another format.
void writeJson(const nlohmann::json& json, const std::string& file);

/// Writes a page where there is none, or over another one.
void writePage(const std::filesystem::path& file, const std::string& page);

} // namespace naocal
