#pragma once

#include "TemporaryFolder.hpp"
#include "judge/Tally.hpp"
#include "seal/Seal.hpp"

#include <nlohmann/json.hpp>

namespace blind {

using nlohmann::json;

inline json knee(double noncentrality) {
  return {{"effect", "elasticity"},
          {"at", "LKneePitch"},
          {"unknowns", {{"c", {{"value", 0.006}, {"unit", "rad/Nm"}}}}},
          {"noncentrality", noncentrality},
          {"kept", 0.4}};
}

inline json truthOf(const std::string& set, const std::string& group, json effects) {
  return {{"set", set},        {"group", group}, {"kind", ""},         {"noise", "clean"},    {"poses", 20},
          {"pictures", false}, {"wanted", 40},   {"effects", effects}, {"lockedFloorPx", 0.5}};
}

inline json diagnosis(const std::string& verdict) {
  return {{"verdict", verdict}, {"ranking", json::array()}, {"suggested", json::array()}, {"drivers", json::array()}};
}

/// Benchmark folder with hand-made truths and answers.
class Bench {
public:
  void add(const json& truth, const json& said, json locked = json::object(), const json& solved = json::object()) {
    const std::string set = truth.at("set");
    const std::string bytes = seal(truth.dump(), "key");
    writeFile(path() / "truth" / "key", "key");
    writeFile(path() / "truth" / (set + ".sealed"), bytes);
    writeFile(path() / "manifest" / (set + ".json"), json{{"truthSha256", sha256Hex(bytes)}}.dump());
    json answer{
        {"set", set}, {"truthSha256", sha256Hex(bytes)}, {"exitCode", 0}, {"locked", locked}, {"diagnosis", said}};
    answer.update(solved);
    writeFile(path() / "answers" / (set + ".json"), answer.dump());
  }
  Marks marked() const { return markAnswer(readCases(path()).front()); }
  const std::filesystem::path& path() const { return folder_.path(); }

private:
  naocal::TemporaryFolder folder_;
};

/// Result of solve with one knee offset.
inline json solvedKnee(double value, double sigma, bool usable = true) {
  const json offset{{"value", value}, {"sigma", sigma}, {"learned", 0.9}};
  return {{"usable", usable},
          {"pValue", 0.3},
          {"rmsPx", 0.6},
          {"noise", {{"pixel", 0.3}, {"jitter", 0.001}, {"source", "repeats"}}},
          {"effects", {{{"effect", "jointOffset"}, {"at", "LKneePitch"}, {"unknowns", {{"o", offset}}}}}}};
}

inline json candidate(const std::string& effect, const std::string& at, std::vector<std::string> equivalent = {}) {
  return {{"effect", effect}, {"at", at}, {"state", "present"}, {"equivalent", equivalent}};
}

} // namespace blind
