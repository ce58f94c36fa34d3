#pragma once

#include "library/naocal.hpp"

#include <filesystem>
#include <memory>
#include <optional>

namespace naocal {

/// Captures as Python holds them: never changed, alive as long as any object or array refers to them.
using SharedCaptures = std::shared_ptr<const Captures>;

/// Where the robots' descriptions are: `given`, else $NAOCAL_CONFIGURATION, else those installed with this package,
/// else those of the source tree.
std::filesystem::path findConfiguration(const std::optional<std::filesystem::path>& given);

/// Captures of a set's text (captures.json), named `name`, as if it had been read from a folder of that name.
SharedCaptures parseCaptures(const std::string& text, const std::string& name, const Robot& robot);

} // namespace naocal
