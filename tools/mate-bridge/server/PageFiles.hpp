#pragma once

#include <optional>
#include <string_view>

namespace naocal {

/// A file of the panel's page, embedded at build time (build.cmake).
struct PageFile {
  std::string_view type, content;
};

/// A file by name: "index.html", "panel.js", "panel.css", "licences.txt". Absent if unknown.
std::optional<PageFile> pageFile(std::string_view name);

/// Why the page is not embedded, in a sentence; empty if it is.
std::string_view pageMissing();

} // namespace naocal
