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

/// Creators of PDFs, as written into them.
inline constexpr std::string_view boardPdfCreator = "naocal board", floorPdfCreator = "naocal floor plan";

/// Throws InputError if a file holds another format, so that no command overwrites it. Files that do not exist, are
/// empty, or are not regular (pipes, devices) are accepted.
void requireSameKind(const std::filesystem::path& file, std::string_view format);

/// The same check for a command-line option that names an output file (- is standard output), before a long
/// computation.
CLI::Validator replaceableFile(std::string format);

/// The same for a PDF of a creator.
CLI::Validator replaceablePdf(std::string_view creator);

/// Throws InputError if the folder holds a set that was not simulated. Removes what killed writers have left in it.
void requireReplaceableSet(const std::filesystem::path& folder);

/// The same for a table (CSV) whose first line is this mark.
CLI::Validator replaceableTable(std::string_view mark);

/// Writes a table that starts with its mark. Throws InputError if the file holds something else than such a table.
void writeTable(const std::filesystem::path& file, const std::string& table);

/// Writes JSON to a file, or to standard output for "-". Throws InputError if the file holds another format.
void writeJson(const nlohmann::json& json, const std::string& file);

/// Writes a report page. Throws InputError if the file holds another format.
void writePage(const std::filesystem::path& file, const std::string& page);

/// Writes a PDF. Throws InputError if the file holds something else than a PDF of this creator.
void writePdf(const std::filesystem::path& file, const std::string& pdf, std::string_view creator);

} // namespace naocal
