#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace naocal {

/// The document in a JSON text; `file` stands for it in messages. Throws InputError with line and column for broken
/// syntax, and for a key that occurs twice in one object.
///
/// The literals NaN, Infinity and -Infinity, which JSON does not know but many writers use, become texts: whoever
/// expects a number there refuses them at their place, and not the whole file because of one.
nlohmann::json parseJson(const std::string& text, const std::string& file);

} // namespace naocal
