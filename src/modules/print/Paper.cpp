#include "print/Paper.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal {

const Paper& findPaper(std::string_view name) {
  const auto* const paper =
      std::find_if(papers.begin(), papers.end(), [&](const Paper& candidate) { return candidate.name == name; });
  if (paper == papers.end()) {
    throw InputError{fmt::format("the paper: expected a4, a3, a2, a1 or a0, found {}", name)};
  }
  return *paper;
}

} // namespace naocal
