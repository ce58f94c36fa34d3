#pragma once

#include <string_view>

/// The files of page/, put into the program when it is built (page/embed.cmake).
namespace naocal::pageFiles {

/// What all pages share: head and verdict, with {{style}}, {{sections}}, {{data}} and {{script}} to be filled in.
extern const std::string_view frame;

struct Page {
  std::string_view sections, style, script;
};

extern const Page result, diagnosis, evaluation;

} // namespace naocal::pageFiles
