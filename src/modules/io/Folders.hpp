#pragma once

#include <filesystem>

namespace naocal {

/// Creates a folder and missing ones above it, durably: a power failure loses none in which something was written
/// atomically. Throws std::filesystem::filesystem_error.
void createFolders(const std::filesystem::path& folder);

/// Makes the names in a folder durable (new, renamed, removed), where the system can do so.
void syncFolder(const std::filesystem::path& folder);

} // namespace naocal
