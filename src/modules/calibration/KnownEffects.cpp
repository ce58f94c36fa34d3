#include "calibration/KnownEffects.hpp"

#include "effects/Catalogue.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <vector>

namespace naocal {

using nlohmann::json;

namespace {

/// Names of the catalogue's effects, of placements, and of those that a result defines.
std::vector<std::string> knownEffects(const json& result) {
  std::vector<std::string> known{effectName::boardPlacement, effectName::stancePlacement};
  for (const Effect& effect : allEffects()) {
    known.push_back(effect.name);
    if (!effect.alias.empty()) {
      known.push_back(effect.alias);
    }
  }
  for (const json& definition : result.value(json::json_pointer{"/model/define"}, json::array())) {
    if (definition.is_object() && definition.contains("name") && definition["name"].is_string()) {
      known.push_back(definition["name"]);
    }
  }
  return known;
}

} // namespace

void requireKnownEffects(const json& result, const std::string& file) {
  const std::vector<std::string> known = knownEffects(result);
  for (const json& effect : result.at("effects")) {
    const std::string name = effect.at("effect").get<std::string>();
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw InputError{fmt::format("{}: effects: expected effects of 'naocal effects' or of the result's own "
                                   "definitions, found \"{}@{}\"; near it are {}",
                                   file, name, effect.at("at").get<std::string>(),
                                   fmt::join(closestNames(name, known), ", "))};
    }
  }
}

} // namespace naocal
