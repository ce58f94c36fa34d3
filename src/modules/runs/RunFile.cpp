#include "runs/RunFile.hpp"

#include "io/FileVersion.hpp"
#include "io/JsonReader.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

namespace naocal {

using nlohmann::json;

namespace {

constexpr Range offsetRange{-3.2, 3.2, "rad"}, sigmaRange{1e-9, 3.2, "rad"}, freedomRange{4, 1e7, ""},
    errorRange{0, 1e6, "px"};
constexpr double mostFreedom = 1e6;
constexpr std::size_t mostJoints = 100;

const std::vector<std::string_view> outcomeWords{"kept", "unneeded", "taken-back"}; // in the order of RunOutcome

/// A text that may be absent or empty.
std::string optionalText(const JsonCursor& place, const std::string& key) {
  const auto found = place.find(key);
  return found && found->value() != "" ? found->text() : "";
}

std::optional<double> optionalPixels(const JsonCursor& place, const std::string& key) {
  const auto found = place.find(key);
  return found && !found->value().is_null() ? std::optional{found->number(errorRange)} : std::nullopt;
}

std::vector<std::pair<std::string, JsonCursor>> jointsOf(const JsonCursor& place) {
  auto joints = place.members();
  if (joints.size() > mostJoints) {
    place.refuse("at most 100 joints");
  }
  return joints;
}

RunOffset readOffset(const JsonCursor& place) {
  RunOffset offset{place.at("offset").number(offsetRange), place.at("sigma").number(sigmaRange)};
  if (const auto freedom = place.find("degreesOfFreedom")) {
    offset.freedom = std::min(freedom->number(freedomRange), mostFreedom);
  }
  return offset;
}

RunRobot readRobot(const JsonCursor& place) {
  return {place.at("body").text(), optionalText(place, "head"), optionalText(place, "bodyId"),
          optionalText(place, "headId")};
}

} // namespace

json runJson(const Run& run) {
  json document = withFormat("naocal-run", {{"time", formatTime(run.time)},
                                            {"robot",
                                             {{"body", run.robot.body},
                                              {"head", run.robot.head},
                                              {"bodyId", run.robot.bodyId},
                                              {"headId", run.robot.headId}}},
                                            {"kind", run.kind},
                                            {"by", run.by}});
  if (run.outcome) {
    document["outcome"] = outcomeWords[static_cast<std::size_t>(*run.outcome)];
    document["heldOut"] = run.heldOut;
  }
  for (const auto& [key, error] :
       {std::pair{"errorBefore", run.errorBefore}, std::pair{"errorAfter", run.errorAfter}}) {
    if (error) {
      document[key] = *error;
    }
  }
  for (const auto& [key, text] : {std::pair{"captures", &run.captures}, std::pair{"result", &run.result},
                                  std::pair{"sha256", &run.sha256}, std::pair{"undoes", &run.undoes}}) {
    if (!text->empty()) {
      document[key] = *text;
    }
  }
  for (const auto& [joint, offset] : run.offsets) {
    document["offsets"][joint] = {
        {"offset", offset.value}, {"sigma", offset.sigma}, {"degreesOfFreedom", offset.freedom}};
  }
  if (!run.set.empty()) {
    document["set"] = run.set;
  }
  return document;
}

Run parseRun(const json& document, const std::string& id, const std::string& name) {
  const JsonCursor all{document, name};
  requireFormat(all, "naocal-run");
  Run run{.id = id};
  const auto time = parseTime(all.at("time").text());
  if (!time) {
    all.at("time").refuse("a time in UTC such as \"2026-02-14T10:05:00Z\"");
  }
  run.time = *time;
  run.robot = readRobot(all.at("robot"));
  run.kind = all.at("kind").text();
  run.by = optionalText(all, "by");
  const bool isEvent = run.kind == undoKind || run.kind == fallKind;
  if (!isEvent) {
    run.outcome = static_cast<RunOutcome>(all.at("outcome").wordIndex(outcomeWords));
    const auto heldOut = all.find("heldOut");
    run.heldOut = heldOut && heldOut->boolean();
  }
  run.errorBefore = optionalPixels(all, "errorBefore");
  run.errorAfter = optionalPixels(all, "errorAfter");
  run.captures = optionalText(all, "captures");
  run.result = optionalText(all, "result");
  run.sha256 = optionalText(all, "sha256");
  run.undoes = optionalText(all, "undoes");
  if (const auto offsets = all.find("offsets")) {
    for (const auto& [joint, offset] : jointsOf(*offsets)) {
      run.offsets[joint] = readOffset(offset);
    }
  }
  if (const auto set = all.find("set")) {
    for (const auto& [joint, offset] : jointsOf(*set)) {
      run.set[joint] = offset.number(offsetRange);
    }
  }
  return run;
}

bool isRunId(const std::string& text) {
  return !text.empty() && text.size() <= 120 && text.front() != '.' &&
         std::all_of(text.begin(), text.end(), [](unsigned char letter) {
           return letter < 128 && (std::isalnum(letter) != 0 || letter == '.' || letter == '-' || letter == '_');
         });
}

std::map<std::string, RunOffset> offsetsOfResult(const json& result, const std::string& name) {
  constexpr double leastLearned = 0.5; // as in calibration/EffectiveOffsets
  std::map<std::string, RunOffset> offsets;
  for (const JsonCursor& effect : JsonCursor{result, name}.at("effects").elements()) {
    if (effect.at("effect").text() != "jointOffset") {
      continue;
    }
    const JsonCursor unknown = effect.at("unknowns").at("o");
    const auto learned = unknown.find("learned"), averaged = unknown.find("averaged");
    if (learned && learned->number({-1e9, 1, ""}) < leastLearned) {
      continue;
    }
    const JsonCursor& estimate = averaged ? *averaged : unknown;
    RunOffset offset{estimate.at("value").number(offsetRange), estimate.at("sigma").number(sigmaRange)};
    if (const auto freedom = unknown.find("degreesOfFreedom")) {
      offset.freedom = std::min(freedom->number(freedomRange), mostFreedom);
    }
    offsets[effect.at("at").text()] = offset;
  }
  return offsets;
}

} // namespace naocal
