#include "Laboratory.hpp"

#include "effects/UserEffect.hpp"
#include "estimation/ModelBuilder.hpp"
#include "estimation/ModelFile.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

/// A person's own effects in the laboratory.
namespace naocal {

namespace {

using Json = nlohmann::json;

} // namespace

void Laboratory::define(const Json& effect) {
  const Effect made = userEffect(JsonPlace{effect, definitionsName}, opened_.robot);
  Rung rung = rungs_[at_];
  Json kept = Json::array();
  for (Json& other : Json::parse(rung.definitions)) {
    if (other["name"] != made.name) {
      kept.push_back(std::move(other));
    }
  }
  kept.push_back(effect);
  rung.definitions = kept.dump();
  const std::string at = effect["at"].get<std::string>(), label = made.name + "@" + at;
  const auto isIt = [&](const std::string& other) { return other.starts_with(made.name + "@"); };
  const bool isIn = std::any_of(rung.with.begin(), rung.with.end(), isIt);
  rung.step = isIn ? "changed " + made.name : at == "*" ? made.name + " offered at every joint" : "+ " + label;
  if (at != "*") { // where it was before, it is no more
    std::erase_if(rung.with, isIt);
    rung.with.push_back(label);
  }
  go(std::move(rung));
}

Json Laboratory::checked(const Json& effect) const {
  try {
    const Effect made = userEffect(JsonPlace{effect, definitionsName}, opened_.robot);
    const std::vector<Effect> all = effectsWith(Json::array({effect}), definitionsName, opened_.robot);
    if (effect["at"] != "*") {
      makeModel(measurements_, {fmt::format("{}@{}", made.name, effect["at"].get<std::string>())}, {}, all);
    }
    return {{"ok", true}};
  } catch (const CorrectionError& error) {
    return {{"ok", false}, {"sentence", error.what()}, {"letter", error.letter}};
  } catch (const InputError& error) {
    return {{"ok", false}, {"sentence", error.what()}};
  }
}

} // namespace naocal
