#include "brain/CalibrationStatus.hpp"

#include "math/Angles.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

constexpr int fewestCorners = 6; // per pose, over all images; below it no board counts as detected

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

std::vector<std::string> posesWithoutBoard(const std::vector<PublishedCapture>& captures) {
  std::map<std::string, int> corners;
  for (const PublishedCapture& capture : captures) {
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

std::string hardlyObserved(const EffectiveOffset& offset, const std::vector<std::string>& unseen) {
  return fmt::format(
      "The {} was hardly observed (learned {:.0f} %) and stays as it was: {}.", inWords(offset.joint),
      100 * std::max(0.0, offset.learned),
      !unseen.empty() ? fmt::format("take poses {} again, in which no board was seen", fmt::join(unseen, ", "))
      : offset.joint == "HeadYaw" ? "how the robot is turned on the floor hides it; calibrate a leg to learn it"
                                  : "take poses that move it before the boards");
}

} // namespace

void to_json(nlohmann::json& out, const CalibrationState& state) {
  constexpr std::array names{"idle",       "preparing", "going home", "waiting",  "moving",
                             "collecting", "solving",   "checking",   "finished", "failed"};
  out = {{"phase", names[static_cast<std::size_t>(state.phase)]},
         {"kind", state.kind},
         {"sentence", state.sentence},
         {"question", state.question},
         {"questionNumber", state.questionNumber},
         {"pose", state.pose},
         {"poses", state.poses},
         {"captures", state.captures},
         {"secondsLeft", state.secondsLeft ? nlohmann::json(*state.secondsLeft) : nlohmann::json()},
         {"errorBefore", state.errorBefore ? nlohmann::json(*state.errorBefore) : nlohmann::json()},
         {"errorAfter", state.errorAfter ? nlohmann::json(*state.errorAfter) : nlohmann::json()}};
}

PublishedPoses listPoses(int round, const CalibrationRound& steps, std::size_t step) {
  PublishedPoses shown{round, 0, {}};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].pictures > 0) {
      shown.step += i < step ? 1 : 0;
      shown.poses.push_back({steps[i].name, steps[i].points.back()});
    }
  }
  return shown;
}

std::vector<EffectiveOffset> learnedOffsets(std::vector<EffectiveOffset> offsets) {
  std::erase_if(offsets, [](const EffectiveOffset& offset) { return !isLearned(offset); });
  return offsets;
}

PublishedOutcome summarizeOutcome(const StoredResult& before, const std::vector<EffectiveOffset>& offsets,
                                  const std::vector<PublishedCapture>& captures) {
  PublishedOutcome outcome;
  const std::vector<std::string> unseen = posesWithoutBoard(captures);
  for (const EffectiveOffset& offset : offsets) {
    if (!isLearned(offset)) {
      outcome.warnings.push_back(hardlyObserved(offset, unseen));
      continue;
    }
    const auto was = before.values.find(fmt::format("jointOffset@{}.o", offset.joint));
    outcome.joints.push_back({offset.joint, was == before.values.end() ? 0 : degrees(was->second),
                              degrees(offset.value), degrees(offset.sigma), offset.learned});
  }
  return outcome;
}

void to_json(nlohmann::json& out, const PublishedPoses& poses) {
  out = {{"round", poses.round}, {"step", poses.step}, {"poses", nlohmann::json::array()}};
  for (const PublishedPoses::Pose& pose : poses.poses) {
    out["poses"].push_back({{"name", pose.name}, {"angles", pose.angles}});
  }
}

void to_json(nlohmann::json& out, const PublishedCapture& capture) {
  out = {{"number", capture.number}, {"round", capture.round},   {"pose", capture.pose},
         {"camera", capture.camera}, {"boards", capture.boards}, {"corners", nullptr}};
  if (capture.corners) {
    out["corners"] = *capture.corners;
  }
}

void to_json(nlohmann::json& out, const PublishedOutcome& outcome) {
  out = {{"joints", nlohmann::json::array()}, {"warnings", outcome.warnings}, {"diagnosis", outcome.diagnosis}};
  if (!outcome.before.empty()) {
    out["before"] = nlohmann::json::parse(outcome.before);
  }
  for (const PublishedOutcome::Offset& offset : outcome.joints) {
    out["joints"].push_back({{"joint", offset.joint},
                             {"before", offset.before},
                             {"after", offset.after},
                             {"sigma", offset.sigma},
                             {"learned", offset.learned}});
  }
}

} // namespace naocal
