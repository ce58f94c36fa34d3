#include "NextStory.hpp"

#include <fmt/core.h>

namespace naocal {

void printNext(const NextPoses& next, AsAsked asked, const std::string& file) {
  if (!next.whyNone.empty()) {
    if (!file.empty()) {
      fmt::print("no poses are proposed, and {} is not written: {}\n", file, next.whyNone);
    }
    return;
  }
  if (next.poses.empty() || file.empty()) {
    fmt::print("measure next what {}:  naocal diagnose {} --next poses.json\n", next.why, asked.words());
    return;
  }
  asked.sets.emplace_back("FURTHER-SET");
  asked.samePlace = true;
  fmt::print(
      "\n{} holds {} poses; what {} grows {:.1f}-fold with them. Take them with the boards where they lie, number "
      "their stance {}, then:\n  naocal diagnose {}\n",
      file, next.poses.size(), next.why, next.growth, next.firstStance, asked.words());
}

} // namespace naocal
