#include "brain/CalibrationShown.hpp"

#include "captures/Files.hpp"
#include "captures/JsonPlace.hpp"
#include "captures/JsonText.hpp"
#include "geometry/Angles.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

constexpr double hardly = 0.5;   // learned: less is hardly observed
constexpr int fewestCorners = 6; // of a pose's pictures in which a board was seen

/// "left knee pitch" for LKneePitch.
std::string inWords(const std::string& joint) {
  const bool left = joint[0] == 'L', right = joint[0] == 'R';
  std::string words = left ? "left" : right ? "right" : "";
  for (const char letter : joint.substr(left || right ? 1 : 0)) {
    if (std::isupper(static_cast<unsigned char>(letter)) && !words.empty()) {
      words += ' ';
    }
    words += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return words;
}

std::vector<std::string> posesWithoutBoard(const std::vector<ShownCapture>& captures) {
  std::map<std::string, int> corners;
  for (const ShownCapture& capture : captures) {
    if (capture.round == 0) {
      corners[capture.pose] += capture.corners.value_or(0);
    }
  }
  std::vector<std::string> poses;
  for (const auto& [pose, count] : corners) {
    if (count < fewestCorners) {
      poses.push_back(pose);
    }
  }
  return poses;
}

std::string hardlyObserved(const ShownOutcome::Offset& offset, const std::vector<std::string>& unseen) {
  return fmt::format(
      "The {} was hardly observed (learned {:.0f} %): {}.", inWords(offset.joint), 100 * std::max(0.0, offset.learned),
      unseen.empty() ? "take poses that move it before the boards"
                     : fmt::format("take poses {} again, in which no board was seen", fmt::join(unseen, ", ")));
}

} // namespace

ShownPoses shownPoses(int round, const CalibrationRound& steps, std::size_t step) {
  ShownPoses shown{round, 0, {}};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].pictures > 0) {
      shown.step += i < step ? 1 : 0;
      shown.poses.push_back({steps[i].name, steps[i].points.back()});
    }
  }
  return shown;
}

ShownOutcome shownOutcome(const std::filesystem::path& result, const StoredResult& before,
                          const std::vector<ShownOffset>& offsets, const std::vector<ShownCapture>& captures) {
  const nlohmann::json document = parseJson(fileContent(result), result.string());
  ShownOutcome outcome;
  for (const nlohmann::json& warning : document.at("warnings")) {
    outcome.warnings.push_back(warning.get<std::string>());
  }
  std::map<std::string, double> learned; // by joint
  for (const nlohmann::json& effect : document.at("effects")) {
    if (effect.at("effect") == "jointOffset") {
      learned[effect.at("at")] = effect.at("unknowns").at("o").at("learned");
    }
  }
  const std::vector<std::string> unseen = posesWithoutBoard(captures);
  for (const ShownOffset& offset : offsets) {
    const auto was = before.values.find(fmt::format("jointOffset@{}.o", offset.joint));
    outcome.joints.push_back({offset.joint, was == before.values.end() ? 0 : degrees(was->second),
                              degrees(offset.value), degrees(offset.sigma), learned.at(offset.joint)});
    if (outcome.joints.back().learned < hardly) {
      outcome.warnings.push_back(hardlyObserved(outcome.joints.back(), unseen));
    }
  }
  return outcome;
}

void to_json(nlohmann::json& out, const ShownPoses& poses) {
  out = {{"round", poses.round}, {"step", poses.step}, {"poses", nlohmann::json::array()}};
  for (const ShownPoses::Pose& pose : poses.poses) {
    out["poses"].push_back({{"name", pose.name}, {"angles", pose.angles}});
  }
}

void to_json(nlohmann::json& out, const ShownCapture& capture) {
  out = {{"number", capture.number}, {"round", capture.round},   {"pose", capture.pose},
         {"camera", capture.camera}, {"boards", capture.boards}, {"corners", nullptr}};
  if (capture.corners) {
    out["corners"] = *capture.corners;
  }
}

void to_json(nlohmann::json& out, const ShownOutcome& outcome) {
  out = {{"joints", nlohmann::json::array()}, {"warnings", outcome.warnings}};
  for (const ShownOutcome::Offset& offset : outcome.joints) {
    out["joints"].push_back({{"joint", offset.joint},
                             {"before", offset.before},
                             {"after", offset.after},
                             {"sigma", offset.sigma},
                             {"learned", offset.learned}});
  }
}

} // namespace naocal
