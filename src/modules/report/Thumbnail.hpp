#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace naocal {

/// A picture as a data URI: grey, JPEG, at most 640 px wide. Absent when the file is not a picture.
std::optional<std::string> thumbnail(const std::filesystem::path& file);

} // namespace naocal
