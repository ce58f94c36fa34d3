#include "judge/Case.hpp"

#include "seal/Seal.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace blind {

namespace {

using nlohmann::json;

std::string named(const json& entry) {
  return canonicalMotor(entry.at("effect").get<std::string>() + "@" + entry.at("at").get<std::string>());
}

std::optional<int> idOf(const json& entry, const char* key) {
  return entry.contains(key) && entry.at(key).is_number() ? std::optional{entry.at(key).get<int>()} : std::nullopt;
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
  truth.plausible = file.value("plausible", 0.0);
  truth.jitter = file.value("jitter", 0.0);
  truth.offsets = file.value("offsets", std::map<std::string, double>{});
  if (file.contains("event")) {
    const json& event = file.at("event");
    truth.event = Truth::Event{event.at("what").get<std::string>(), event.at("at").get<std::string>(),
                               event.at("before").get<double>(), event.at("after").get<double>(), idOf(event, "from")};
  }
  truth.machine = file.value("machine", false);
  truth.setUp = file.value("setUp", "");
  truth.badCapture = idOf(file, "badCapture");
  return truth;
}

Answer::Candidate readCandidate(const json& entry) {
  Answer::Candidate candidate;
  candidate.name = named(entry);
  candidate.state = entry.value("state", "");
  for (const json& other : entry.value("equivalent", json::array())) {
    candidate.equivalent.push_back(canonicalMotor(other.get<std::string>()));
  }
  const json unknowns = entry.value("unknowns", json::object());
  for (const auto& [name, unknown] : unknowns.items()) {
    if (unknown.contains("value") && unknown.contains("sigma") && unknown.at("value").is_number()) {
      candidate.unknowns[name] = {unknown.at("value").get<double>(), unknown.at("sigma").get<double>()};
    }
  }
  return candidate;
}

/// The number before " s", such as in "board B moved 12.3 s after the first capture".
std::optional<double> timeIn(const std::string& why) {
  for (std::size_t end = why.find(" s"); end != why.npos; end = why.find(" s", end + 1)) {
    const std::size_t begin = why.find_last_not_of("0123456789.", end - 1) + 1;
    const bool ends = end + 2 == why.size() || std::isalpha(static_cast<unsigned char>(why[end + 2])) == 0;
    if (ends && begin < end) {
      return std::stod(why.substr(begin, end - begin));
    }
  }
  return std::nullopt;
}

/// The offset shown first: averaged over alternative models, if available.
Solved::Offset readOffset(const json& unknown) {
  const json& shown = unknown.contains("averaged") ? unknown.at("averaged") : unknown;
  const double value = shown.at("value").get<double>(), sigma = shown.at("sigma").get<double>();
  const auto limits = [&](const char* key, double sigmas) {
    return shown.value(key, std::array{value - sigmas * sigma, value + sigmas * sigma});
  };
  const auto [low, high] = limits("interval", 1.96);
  const auto [boundLow, boundHigh] = limits("bound", 3.5);
  return {value, sigma, low, high, boundLow, boundHigh, unknown.value("learned", 1.0)};
}

std::optional<Solved> readSolved(const json& file, const char* key) {
  const json result = file.value(key, json{});
  if (!result.is_object() || !result.contains("effects") || !result.contains("pValue")) { // without: not fitted
    return std::nullopt;
  }
  Solved solved;
  solved.usable = result.at("usable").get<bool>();
  solved.pValue = result.at("pValue").get<double>();
  solved.rmsPx = result.at("rmsPx").is_number() ? result.at("rmsPx").get<double>() : 0; // no corners
  for (const auto& [name, level] : result.at("noise").items()) {
    if (level.is_number()) {
      solved.noise[name] = level.get<double>();
    }
  }
  for (const json& effect : result.at("effects")) {
    if (effect.at("effect") == "jointOffset") {
      solved.offsets[effect.at("at").get<std::string>()] = readOffset(effect.at("unknowns").at("o"));
    }
  }
  return solved;
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
  answer.first = readSolved(file, "solved");
  answer.suggestedAdded = readSolved(file, "solvedWithSuggested");
  if (const auto fixed = readSolved(file, "solvedWithFixedNoise")) {
    answer.fixedNoisePx = fixed->rmsPx;
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
    answer.suggested.push_back(canonicalMotor(entry.get<std::string>()));
  }
  for (const json& entry : diagnosis.value("drivers", json::array())) {
    const json expression = entry.value("expression", json{});
    answer.drivers.push_back({entry.at("at").get<std::string>(), entry.value("driver", ""),
                              expression.is_string() ? expression.get<std::string>() : ""});
  }
  for (const json& entry : diagnosis.value("suspicious", json::array())) {
    const std::string why = entry.value("why", "");
    const json time = entry.value("time", json{}), moved = entry.value("moved", json{});
    answer.suspicious.push_back({why, time.is_number() ? std::optional{time.get<double>()} : timeIn(why),
                                 entry.value("setUp", ""), moved.is_string() ? moved.get<std::string>() : "",
                                 idOf(entry, "capture"), idOf(entry, "from")});
  }
  return answer;
}

} // namespace

std::string canonicalMotor(const std::string& effectAtPlace) {
  constexpr std::string_view spring = "spring@";
  if (effectAtPlace.starts_with(spring)) {
    return canonicalMotor("elasticity@" + effectAtPlace.substr(spring.size()));
  }
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
    throw std::runtime_error{
        fmt::format("{}: expected answers/NAME.json beside the sealed truths, found no answer yet", folder.string())};
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
    cases.push_back({readTruth(json::parse(unseal(sealedBytes, key))), readAnswer(answer)});
  }
  return cases;
}

} // namespace blind
