#include "simulation/Truth.hpp"

#include "data/BoardFile.hpp"
#include "io/FileVersion.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::ordered_json;

Json placementJson(const Placement& placement) {
  return {{"x", placement.x}, {"y", placement.y}, {"yaw", placement.yaw}};
}

Json placementsJson(const TruePlacements& placements) {
  Json boards = Json::object(), stances = Json::object();
  for (const auto& [id, placement] : placements.boards) {
    boards[id] = placementJson(placement);
  }
  for (const auto& [id, placement] : placements.stances) {
    stances[std::to_string(id)] = placementJson(placement);
  }
  return {{"boards", boards}, {"stances", stances}};
}

Json sceneJson(const TrueScene& scene) {
  Json lists = Json::object();
  for (const auto& [list, placements] : scene.placements) {
    for (const auto& [id, placement] : placements) {
      Json& written = lists[list][id];
      for (const PlacementKey& key : placementKeys) {
        written[key.key] = placement.*key.value;
      }
    }
  }
  for (const auto& [id, point] : scene.markers) {
    lists["markers"][id] = {point.x(), point.y(), point.z()};
  }
  for (const auto& [id, point] : scene.places) {
    lists["places"][id] = {point.x(), point.y(), point.z()};
  }
  return lists;
}

Json unknownJson(const TrueUnknown& unknown) {
  return {{"value", unknown.value}, {"unit", unknown.unit}};
}

Json effectJson(const TrueEffect& effect) {
  Json unknowns = Json::object();
  for (const TrueUnknown& unknown : effect.unknowns) {
    unknowns[unknown.name] = unknownJson(unknown);
  }
  return {{"effect", effect.effect}, {"at", effect.at}, {"unknowns", unknowns}};
}

} // namespace

std::optional<double> Truth::value(std::string_view effect, std::string_view at, std::string_view unknown) const {
  for (const TrueEffect& candidate : effects) {
    for (const TrueUnknown& number : candidate.unknowns) {
      if (candidate.effect == effect && candidate.at == at && number.name == unknown) {
        return number.value;
      }
    }
  }
  return std::nullopt;
}

std::string formatTruth(const Truth& truth) {
  Json effects = Json::array(), noise = Json::object(), displaced = Json::array(), gross = Json::array();
  for (const TrueEffect& effect : truth.effects) {
    effects.push_back(effectJson(effect));
  }
  for (const auto& [name, level] : truth.noise) {
    noise[name] = unknownJson(level);
  }
  for (const DisplacedBoard& board : truth.displacedBoards) {
    displaced.push_back({{"capture", board.capture}, {"board", board.board}, {"x", board.x}, {"y", board.y}});
  }
  for (const GrossCorner& corner : truth.grossCorners) {
    gross.push_back({{"capture", corner.capture}, {"board", corner.board}, {"corner", corner.corner}});
  }
  if (truth.scene) {
    const Json json = withFormatInOrder("naocal-truth", {{"seed", truth.seed},
                                                         {"effects", effects},
                                                         {"placements", sceneJson(*truth.scene)},
                                                         {"noise", noise},
                                                         {"grossCorners", gross}});
    return json.dump(1) + "\n";
  }
  const Json json = withFormatInOrder("naocal-truth", {{"seed", truth.seed},
                                                       {"effects", effects},
                                                       {"placements", placementsJson(truth.placements)},
                                                       {"simulatorWorld", placementsJson(truth.ownWorld)},
                                                       {"noise", noise},
                                                       {"displacedBoards", displaced},
                                                       {"grossCorners", gross}});
  return json.dump(1) + "\n";
}

std::filesystem::path truthPath(const std::filesystem::path& setFolder) {
  const std::filesystem::path folder = std::filesystem::absolute(setFolder / "").lexically_normal().parent_path();
  return folder.parent_path() / (folder.filename().string() + ".truth.json");
}

} // namespace naocal
