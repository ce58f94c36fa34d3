#pragma once

#include "setups/SetUp.hpp"

#include <cstddef>
#include <set>
#include <utility>

namespace naocal {

/// Some captures of some sets.
struct CaptureSelection {
  std::set<std::pair<std::size_t, int>> captures; // index of the set, id

  /// The same sets with these captures only.
  Recording of(const Recording& recording) const;
};

/// So many captures that they measure several numbers per unknown, as far apart from each other as possible, so that
/// those are among them in which a joint moves that hardly ever does.
CaptureSelection selectCaptures(const Measurements& measurements, std::size_t unknowns);

} // namespace naocal
