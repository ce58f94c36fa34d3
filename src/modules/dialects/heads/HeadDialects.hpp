#pragma once

#include "dialects/heads/HeadDialect.hpp"

#include <span>

namespace naocal {

/// Dialects of files that hold a head camera's direction.
std::span<const HeadDialect> headDialects();

/// The one of this name, or null.
const HeadDialect* findHeadDialect(std::string_view name);

} // namespace naocal
