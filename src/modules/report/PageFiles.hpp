#pragma once

#include <span>
#include <string_view>

/// The files of web/, embedded at build time (web/pages/embed.cmake).
namespace naocal::pageFiles {

/// Common frame of all pages: head and verdict, with the placeholders {{style}}, {{sections}}, {{data}}, {{modules}}
/// and {{page}}.
extern const std::string_view frame;

/// All scripts as entries of an import map, "name":"address".
extern const std::span<const std::string_view> modules;

/// A page; starts with the script pages/NAME.js.
struct Page {
  std::string_view name, sections, style;
};

extern const Page result, diagnosis, evaluation;

} // namespace naocal::pageFiles
