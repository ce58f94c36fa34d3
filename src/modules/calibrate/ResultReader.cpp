#include "calibrate/ResultFile.hpp"

#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

using nlohmann::json;

namespace {

Placement placementFrom(const json& value) {
  return {value.value("x", 0.0),    value.value("y", 0.0),     value.value("z", 0.0),
          value.value("roll", 0.0), value.value("pitch", 0.0), value.value("yaw", 0.0)};
}

Noise noiseFrom(const json& entry, const std::filesystem::path& file) {
  const Noise usual;
  const Noise noise{.pixel = entry.value("pixel", usual.pixel),
                    .encoder = entry.value("encoder", usual.encoder),
                    .pose = entry.value("pose", usual.pose),
                    .stance = entry.value("stance", usual.stance),
                    .reapproach = entry.value("reapproach", usual.reapproach),
                    .pixelAlike = entry.value("pixelAlike", usual.pixelAlike)};
  if (!(noise.pixel > 0 && noise.encoder >= 0 && noise.pose >= 0 && noise.stance >= 0 && noise.reapproach >= 0 &&
        noise.pixelAlike >= 0)) {
    throw InputError{fmt::format("{}: noise: expected a positive pixel and no negative numbers, found {}",
                                 file.string(), entry.dump())};
  }
  return noise;
}

} // namespace

StoredResult readResult(const std::filesystem::path& file) {
  try {
    const json all = json::parse(fileContent(file));
    if (all.value("format", "") != "naocal-result" || all.value("version", 0) != 1) {
      throw InputError{
          fmt::format("{}: format: expected \"naocal-result\" version 1, as 'naocal solve' writes it, found {} "
                      "version {}",
                      file.string(), all.value("format", "none"), all.value("version", 0))};
    }
    StoredResult result;
    result.usable = all.at("usable").get<bool>();
    if (all.contains("model") && all["model"].contains("define")) {
      result.definitions = all["model"]["define"].dump();
    }
    result.noise = noiseFrom(all.value("noise", json::object()), file);
    for (const json& effect : all.at("effects")) {
      const std::string label = effect.at("effect").get<std::string>() + "@" + effect.at("at").get<std::string>();
      result.terms.push_back(label);
      for (const auto& [name, unknown] : effect.at("unknowns").items()) {
        result.values[label + "." + name] = unknown.at("value").get<double>();
      }
    }
    for (const auto& [name, placement] : all.at("placements").at("boards").items()) {
      result.boards[name] = placementFrom(placement);
    }
    for (const auto& [name, placement] : all.at("placements").at("stances").items()) {
      result.stances[name] = placementFrom(placement);
    }
    return result;
  } catch (const json::exception& error) {
    throw InputError{fmt::format("{}: not a result file as 'naocal solve' writes it: {}", file.string(), error.what())};
  }
}

} // namespace naocal
