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

/// Creators of PDFs, as written into them.
inline constexpr std::string_view boardPdfCreator = "naocal board", floorPdfCreator = "naocal floor plan";

/// Requires the same kind (`requireSameKind`) of a command-line option that names an output file (- is standard
/// output), before a long computation.
CLI::Validator replaceableFile(std::string format);

/// The same for a PDF of a creator.
CLI::Validator replaceablePdf(std::string_view creator);

/// Throws InputError if the folder holds a set that was not simulated. Removes what killed writers have left in it.
void requireReplaceableSet(const std::filesystem::path& folder);

/// Writes JSON to a file, or to standard output for "-". Throws InputError if the file holds another format.
void writeJson(const nlohmann::json& json, const std::string& file);

/// Writes a report page. Throws InputError if the file holds another format.
void writePage(const std::filesystem::path& file, const std::string& page);

/// Writes a PDF. Throws InputError if the file holds something else than a PDF of this creator.
void writePdf(const std::filesystem::path& file, const std::string& pdf, std::string_view creator);

} // namespace naocal
