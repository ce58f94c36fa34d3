#pragma once

#include <optional>
#include <string_view>

namespace naocal {

/// A file of the panel's page, put into the program when it is built (build.cmake).
struct PageFile {
  std::string_view type, content;
};

/// By name: "index.html", "panel.js", "panel.css", "licences.txt". Absent when there is no such file.
std::optional<PageFile> pageFile(std::string_view name);

/// Why the page is not in this program, in a sentence; empty when it is.
std::string_view pageMissing();

} // namespace naocal
