#pragma once

#include "io/FileKind.hpp"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace CLI {
class Validator;
}

namespace naocal {

/// Requires the same kind (`requireSameKind`) of a command-line option that names an output file (- is standard
/// output), before a long computation.
CLI::Validator replaceableFile(std::string format);

/// Throws InputError if the folder holds a set that was not simulated. Removes what killed writers have left in it.
void requireReplaceableSet(const std::filesystem::path& folder);

/// The same for a table (CSV) whose first line is this mark.
CLI::Validator replaceableTable(std::string_view mark);

/// Writes a table that starts with its mark. Throws InputError if the file holds something else than such a table.
void writeTable(const std::filesystem::path& file, const std::string& text);

/// Writes JSON to a file, or to standard output for "-". Throws InputError if the file holds another format.
void writeJson(const nlohmann::json& json, const std::string& file);

/// Writes a report page. Throws InputError if the file holds another format.
void writePage(const std::filesystem::path& file, const std::string& page);

} // namespace naocal
