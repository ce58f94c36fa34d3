#pragma once

#include "effects/Effect.hpp"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// A model as people write it down: effects at places to add and to leave out, and effects of their own.
struct ModelFile {
  std::vector<std::string> with, without; // "E@P"
  std::string definitions = "[]";         // effects of their own: a list of JSON
  std::vector<Effect> effects;            // the built-in ones, then those
};

/// Reads {"format": "naocal-model", "version": 1, "with": ["E@P"], "without": [], "define": [user effects]}.
/// Throws InputError with file, place, what was expected and found.
ModelFile readModelFile(const std::filesystem::path& file, const Robot& robot);

/// What `readModelFile` reads. `define`: a list of a person's own effects.
nlohmann::json modelFileJson(const std::vector<std::string>& with, const std::vector<std::string>& without,
                             nlohmann::json define);

/// The built-in effects and those defined in a list of JSON (`effects/UserEffect.hpp`); `file` stands for it in
/// messages.
std::vector<Effect> parseEffects(const nlohmann::json& definitions, const std::string& file, const Robot& robot);

} // namespace naocal
