#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace naocal {

/// Throws InputError if an effect of a result is neither in the catalogue nor among the result's own definitions:
/// whoever reads the result would leave it out without a word. Called by `parseResult`; for others that read a result's
/// document. `file` stands for it in messages. Throws nlohmann's exceptions for what is no result.
void requireKnownEffects(const nlohmann::json& result, const std::string& file);

} // namespace naocal
