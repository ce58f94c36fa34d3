#include "commands/Commands.hpp"
#include "console/CommandLine.hpp"
#include "console/OutputFiles.hpp"
#include "console/print/PrintText.hpp"

#include "command-line/OptionChecks.hpp"
#include "estimation/ModelFile.hpp"
#include "io/FileVersion.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

struct EffectsCommand {
  std::string json, model;
};

const char* places(const Effect& effect) {
  switch (effect.placeKind) {
  case PlaceKind::motor:
    return effect.onlyAtMotor ? "one joint" : "joint";
  case PlaceKind::joint:
    return "joint (each hip yaw-pitch)";
  case PlaceKind::camera:
    return "top, bottom";
  case PlaceKind::board:
    return effect.shared ? "board id, or all" : "board id";
  case PlaceKind::sole:
    return "left, right (soles)";
  case PlaceKind::length:
    return "neckZ, hipZ, hipY, thigh, tibia, footZ";
  case PlaceKind::all:
    return "all";
  case PlaceKind::tracker:
    return "tracker id";
  case PlaceKind::stance:
  case PlaceKind::marker:
  case PlaceKind::frame:
  case PlaceKind::place:
    break;
  }
  return "stance";
}

/// The capture file's key for a driver, in addition to angles and corners; nullptr if none is needed.
const char* key(Driver driver) {
  switch (driver) {
  case Driver::torque:
  case Driver::torqueGrowth:
  case Driver::lateral1:
  case Driver::lateral2:
    return "fsr (on both feet)";
  case Driver::com:
    return "a support foot";
  case Driver::approach:
    return "joints.approach";
  case Driver::temperature:
    return "joints.temperature";
  case Driver::velocity:
    return "joints.velocity";
  case Driver::current:
    return "joints.current";
  case Driver::time:
    return "time";
  case Driver::imu:
    return "imu";
  case Driver::angle:
    break;
  }
  return nullptr;
}

std::vector<std::string> neededKeys(const Effect& effect, const Robot& robot) {
  std::vector<std::string> result;
  const auto add = [&](const std::string& needed) {
    if (std::find(result.begin(), result.end(), needed) == result.end()) {
      result.push_back(needed);
    }
  };
  for (const Driver driver : effect.drivers) {
    if (const char* const needed = key(driver)) {
      add(needed);
    }
  }
  for (const RemoteDriver& other : effect.remoteDrivers) {
    add("joints.measured of " + robot.joints[other.joint].name);
    if (const char* const needed = key(other.driver)) {
      add(needed);
    }
  }
  return result;
}

/// Names of the places on the robot; of boards only "all", for the captures name them.
std::vector<std::string> namesOfPlaces(const Effect& effect, const Robot& robot) {
  std::vector<std::string> names;
  const auto add = [&](const auto& list) {
    for (const auto& each : list) {
      names.push_back(each.name);
    }
  };
  switch (effect.placeKind) {
  case PlaceKind::motor:
  case PlaceKind::joint:
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      const bool isPlace = effect.placeKind == PlaceKind::joint || robot.joints[i].motor == i;
      if (isPlace && effect.onlyAtMotor.value_or(i) == i) {
        names.push_back(robot.joints[i].name);
      }
    }
    break;
  case PlaceKind::camera:
    add(robot.cameras);
    break;
  case PlaceKind::sole:
    add(robot.soles);
    break;
  case PlaceKind::length:
    add(robot.lengths);
    break;
  case PlaceKind::board:
  case PlaceKind::all:
    if (effect.shared || effect.placeKind == PlaceKind::all) {
      names.emplace_back("all");
    }
    break;
  case PlaceKind::stance:
  case PlaceKind::tracker:
  case PlaceKind::marker:
  case PlaceKind::frame:
  case PlaceKind::place:
    break;
  }
  return names;
}

nlohmann::json effectsJson(const std::vector<Effect>& effects, const Robot& robot) {
  nlohmann::json list = nlohmann::json::array();
  for (const Effect& effect : effects) {
    nlohmann::json unknowns;
    for (const Unknown& unknown : effect.unknowns) {
      unknowns[unknown.name] = {{"unit", unknown.unit}, {"sigma", unknown.sigma}};
    }
    list.push_back({{"effect", effect.name},
                    {"what", effect.description},
                    {"at", places(effect)},
                    {"places", namesOfPlaces(effect, robot)},
                    {"formula", effect.formula},
                    {"unknowns", std::move(unknowns)},
                    {"needs", neededKeys(effect, robot)},
                    {"smooth", !effect.kink}});
    if (!effect.alias.empty()) {
      list.back()["alias"] = effect.alias;
    }
  }
  return withFormat("naocal-effects", nlohmann::json{{"effects", std::move(list)}});
}

void print(const Effect& effect, const Robot& robot) {
  std::vector<std::string> unknowns;
  for (const Unknown& unknown : effect.unknowns) {
    unknowns.push_back(
        fmt::format("{} ± {:g}{}", unknown.name, unknown.sigma, unknown.unit == "1" ? "" : " " + unknown.unit));
  }
  const std::vector<std::string> needs = neededKeys(effect, robot);
  printText("{}\n  {}\n  {:<9} {}\n  {:<9} {}\n  {:<9} {}\n", effect.name, effect.description, "formula",
            effect.formula, "at", places(effect), "unknowns", fmt::join(unknowns, ", "));
  if (!effect.alias.empty()) {
    printText("  {:<9} {}\n", "alias", effect.alias);
  }
  if (!needs.empty()) {
    printText("  {:<9} {}\n", "needs", fmt::join(needs, ", "));
  }
  printText("\n");
}

void listEffects(const EffectsCommand& command) {
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  const std::vector<Effect> effects =
      command.model.empty() ? allEffects() : readModelFile(command.model, robot).effects;
  if (!command.json.empty()) {
    writeJson(effectsJson(effects, robot), command.json);
  }
  if (command.json == "-") {
    return;
  }
  printText(
      "Each can be added to a calibration: naocal solve SET --with EFFECT@PLACE. The number behind ± says how far\n"
      "from zero an unknown plausibly lies (1 sigma).\n\n");
  for (const Effect& effect : effects) {
    print(effect, robot);
  }
}

} // namespace

void addEffects(CLI::App& app) {
  auto command = std::make_shared<EffectsCommand>();
  CLI::App* lister = app.get_subcommand("effects");
  lister->footer("Example: naocal effects --model my-model.json");
  lister->add_option("--json", command->json, "write JSON to a file, or - for standard output")
      ->type_name("FILE")
      ->check(replaceableFile("naocal-effects"));
  lister->add_option("--model", command->model, "a model file: lists the effects that it defines too")
      ->type_name("FILE");
  lister->callback([command] { listEffects(*command); });
}

} // namespace naocal
