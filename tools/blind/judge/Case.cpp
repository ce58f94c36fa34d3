#include "judge/Case.hpp"

#include "seal/Seal.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace blind {

namespace {

using nlohmann::json;

std::string named(const json& entry) {
  return sameMotor(entry.at("effect").get<std::string>() + "@" + entry.at("at").get<std::string>());
}

Truth readTruth(const json& file) {
  Truth truth;
  truth.set = file.at("set").get<std::string>();
  truth.group = file.at("group").get<std::string>();
  truth.kind = file.at("kind").get<std::string>();
  truth.noise = file.at("noise").get<std::string>();
  truth.poses = file.at("poses").get<int>();
  truth.pictures = file.at("pictures").get<bool>();
  truth.wanted = file.at("wanted").get<double>();
  truth.lockedFloorPx = file.at("lockedFloorPx").get<double>();
  for (const json& entry : file.at("effects")) {
    Truth::Effect effect;
    effect.name = named(entry);
    effect.noncentrality = entry.at("noncentrality").get<double>();
    for (const auto& [name, unknown] : entry.at("unknowns").items()) {
      effect.unknowns[name] = unknown.at("value").get<double>();
    }
    effect.drivers = entry.value("drivers", std::vector<std::string>{});
    truth.effects.push_back(std::move(effect));
  }
  return truth;
}

Answer::Candidate readCandidate(const json& entry) {
  Answer::Candidate candidate;
  candidate.name = named(entry);
  candidate.state = entry.value("state", "");
  for (const json& other : entry.value("equivalent", json::array())) {
    candidate.equivalent.push_back(sameMotor(other.get<std::string>()));
  }
  const json unknowns = entry.value("unknowns", json::object());
  for (const auto& [name, unknown] : unknowns.items()) {
    if (unknown.contains("value") && unknown.contains("sigma") && unknown.at("value").is_number()) {
      candidate.unknowns[name] = {unknown.at("value").get<double>(), unknown.at("sigma").get<double>()};
    }
  }
  return candidate;
}

Answer readAnswer(const json& file) {
  Answer answer;
  answer.exitCode = file.at("exitCode").get<int>();
  answer.seconds = file.value("seconds", 0.0);
  const json& locked = file.at("locked");
  if (locked.contains("beforePx") && locked.contains("afterPx")) {
    answer.lockedBeforePx = locked.at("beforePx").get<double>();
    answer.lockedAfterPx = locked.at("afterPx").get<double>();
    answer.lockedFell = locked.value("weightedAfterPx", *answer.lockedAfterPx) <
                        locked.value("weightedBeforePx", *answer.lockedBeforePx);
  }
  const json& diagnosis = file.at("diagnosis");
  if (diagnosis.is_null()) {
    return answer;
  }
  answer.verdict = diagnosis.at("verdict").get<std::string>();
  for (const json& entry : diagnosis.value("ranking", json::array())) {
    answer.ranking.push_back(readCandidate(entry));
  }
  for (const json& entry : diagnosis.value("suggested", json::array())) {
    answer.suggested.push_back(sameMotor(entry.get<std::string>()));
  }
  for (const json& entry : diagnosis.value("drivers", json::array())) {
    answer.drivers.push_back({entry.at("at").get<std::string>(), entry.value("driver", "")});
  }
  return answer;
}

} // namespace

std::string sameMotor(const std::string& effectAtPlace) {
  constexpr std::string_view right = "@RHipYawPitch";
  if (effectAtPlace.ends_with(right) && !effectAtPlace.starts_with("axisTilt@")) {
    return effectAtPlace.substr(0, effectAtPlace.size() - right.size()) + "@LHipYawPitch";
  }
  return effectAtPlace;
}

std::vector<Case> readCases(const std::filesystem::path& folder) {
  const std::string key = readFile(folder / "truth" / "key");
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::exists(folder / "answers")) {
    throw std::runtime_error{fmt::format(
        "{}: expected answers/NAME.json beside the sealed truths, found no answer yet", folder.string())};
  }
  for (const auto& entry : std::filesystem::directory_iterator{folder / "answers"}) {
    if (entry.path().extension() == ".json") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<Case> cases;
  for (const std::filesystem::path& file : files) {
    const json answer = json::parse(readFile(file));
    const std::string set = answer.at("set").get<std::string>();
    const json manifest = json::parse(readFile(folder / "manifest" / (set + ".json")));
    const std::string sealedBytes = readFile(folder / "truth" / (set + ".sealed"));
    const std::string hash = manifest.at("truthSha256").get<std::string>();
    if (sha256Hex(sealedBytes) != hash) {
      throw std::runtime_error{
          fmt::format("{}: the truth is not the one that was sealed; nothing is judged", (folder / set).string())};
    }
    if (answer.at("truthSha256") != hash) {
      throw std::runtime_error{fmt::format(
          "{}: the answer was given to another sealed truth; nothing is judged, remove the answer and ask anew",
          file.string())};
    }
    cases.push_back({readTruth(json::parse(opened(sealedBytes, key))), readAnswer(answer)});
  }
  return cases;
}

} // namespace blind
