#pragma once

#include <string_view>

/// The files of page/, put into the program when it is built (page/embed.cmake).
namespace naocal::pageFiles {

extern const std::string_view page; // the skeleton, with {{style}}, {{script}} and {{data}}
extern const std::string_view style;
extern const std::string_view script; // all scripts, one after the other

} // namespace naocal::pageFiles
