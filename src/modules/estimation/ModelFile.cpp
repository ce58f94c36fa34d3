#include "estimation/ModelFile.hpp"

#include "effects/Catalogue.hpp"
#include "effects/UserEffect.hpp"
#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/JsonReader.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

namespace {

std::vector<Effect> addBuiltIn(const std::vector<Effect>& defined) {
  std::vector<Effect> result = allEffects();
  result.insert(result.end(), defined.begin(), defined.end());
  return result;
}

} // namespace

std::vector<Effect> parseEffects(const nlohmann::json& definitions, const std::string& file, const Robot& robot) {
  return addBuiltIn(parseUserEffects(JsonCursor{definitions, file}, robot));
}

nlohmann::json modelFileJson(const std::vector<std::string>& with, const std::vector<std::string>& without,
                             nlohmann::json define) {
  return withFormat("naocal-model", {{"with", with}, {"without", without}, {"define", std::move(define)}});
}

ModelFile readModelFile(const std::filesystem::path& file, const Robot& robot) {
  const nlohmann::json document = parseJson(readFile(file), file.string());
  const JsonCursor all{document, file.string()};
  requireFormat(all, "naocal-model");
  ModelFile result;
  for (const auto& [key, list] : {std::pair{"with", &result.with}, std::pair{"without", &result.without}}) {
    if (const auto terms = all.find(key)) {
      for (const JsonCursor& term : terms->elements()) {
        list->push_back(term.text());
      }
    }
  }
  const auto define = all.find("define");
  result.effects = addBuiltIn(define ? parseUserEffects(*define, robot) : std::vector<Effect>{});
  result.definitions = define ? define->value().dump() : "[]";
  return result;
}

} // namespace naocal
