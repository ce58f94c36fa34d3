#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace CLI {
class Validator;
}

namespace naocal {

/// Creators of PDFs, as written into them.
inline constexpr std::string_view boardPdfCreator = "naocal board", floorPdfCreator = "naocal floor plan";

/// The check for a command-line option that names a PDF to write, before a long computation: refuses to overwrite
/// something else than a PDF of this creator.
CLI::Validator replaceablePdf(std::string_view creator);

/// Writes a PDF. Throws InputError if the file holds something else than a PDF of this creator.
void writePdf(const std::filesystem::path& file, const std::string& pdf, std::string_view creator);

} // namespace naocal
