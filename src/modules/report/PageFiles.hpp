#pragma once

#include <span>
#include <string_view>

/// The files of web/, put into the program when it is built (web/pages/embed.cmake).
namespace naocal::pageFiles {

/// What all pages share: head and verdict, with {{style}}, {{sections}}, {{data}}, {{modules}} and {{page}} to be
/// filled in.
extern const std::string_view frame;

/// All scripts as entries of an import map, "name":"address".
extern const std::span<const std::string_view> modules;

/// A page; the script pages/NAME.js starts it.
struct Page {
  std::string_view name, sections, style;
};

extern const Page result, diagnosis, evaluation;

} // namespace naocal::pageFiles
