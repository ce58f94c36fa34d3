#pragma once

#include "effects/Effect.hpp"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// A model in file form: effects to add and to remove, and user-defined effects.
struct ModelFile {
  std::vector<std::string> with, without; // "E@P"
  std::string definitions = "[]";         // user-defined effects: a JSON list
  std::vector<Effect> effects;            // built-in effects, then user-defined ones
};

/// Reads {"format": "naocal-model", "version": 1, "with": ["E@P"], "without": [], "define": [user effects]}. Throws
/// InputError with file, location, expected and found.
ModelFile readModelFile(const std::filesystem::path& file, const Robot& robot);

/// The JSON that `readModelFile` reads. `define`: list of user-defined effects.
nlohmann::json modelFileJson(const std::vector<std::string>& with, const std::vector<std::string>& without,
                             nlohmann::json define);

/// The built-in effects and those defined in a JSON list (`effects/UserEffect.hpp`). `file` names the list in messages.
std::vector<Effect> parseEffects(const nlohmann::json& definitions, const std::string& file, const Robot& robot);

} // namespace naocal
