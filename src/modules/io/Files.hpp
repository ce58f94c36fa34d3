#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace naocal {

/// The whole content of a file. Throws InputError that names the file and the reason.
std::string fileContent(const std::filesystem::path& file);

/// Writes a file whole or not at all: temporary file beside it, fsync, rename. Throws InputError with the reason.
void writeAtomically(const std::filesystem::path& file, std::string_view content);

/// Lower-case hexadecimal SHA-256.
std::string sha256(std::string_view content);

} // namespace naocal
