#pragma once

#include "OpenedSets.hpp"

#include <filesystem>
#include <string>

namespace naocal {

/// Whether that is a folder; what cannot be looked at is none.
bool isFolder(const std::filesystem::path& path);

/// A set to those that are opened; pictures whose corners were not looked for are searched. Throws InputError.
void addSet(const std::string& folder, OpenedSets& opened);

/// A set, or the sets that lie in a folder of them, as the robot records a calibration. Throws InputError.
void addFolder(const std::string& folder, OpenedSets& opened);

/// The folder of a set as a document names it: as it is written, else beside the document. Throws InputError.
std::string folderOf(const std::string& written, const std::filesystem::path& document);

} // namespace naocal
