#pragma once

#include "captures/GreyPicture.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace naocal {

/// A picture file's grey levels; colours become their luma, what is transparent white. Throws
/// InputError, with what the picture is called, where it is neither PNG nor JPEG, is cut off or has more than 64
/// million pixels.
GreyPicture decodedPicture(std::string_view content, const std::string& name);
GreyPicture readPicture(const std::filesystem::path& file);

/// As a PNG: every grey level is kept.
std::string png(const GreyPicture& picture);

/// As a JPEG. `pixels`: row by row, width * height of them, one byte each or three (red, green, blue); `quality` 1 to
/// 100.
std::string jpeg(std::span<const std::uint8_t> pixels, int width, int height, int quality);

/// Writes a PNG or JPEG, as the file's name ends (.png, .jpg), at once or not at all. Throws InputError.
void writePicture(const GreyPicture& picture, const std::filesystem::path& file);

} // namespace naocal
