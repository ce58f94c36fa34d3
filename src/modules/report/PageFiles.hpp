#pragma once

#include <string_view>

/// The files of page/, put into the program when it is built (page/embed.cmake).
namespace naocal::pageFiles {

struct Page {
  std::string_view skeleton; // with {{style}}, {{script}} and {{data}}
  std::string_view style, script;
};

extern const Page result, diagnosis;

} // namespace naocal::pageFiles
