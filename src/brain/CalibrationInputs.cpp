#include "brain/CalibrationInputs.hpp"

#include "data/BoardFile.hpp"
#include "estimation/Model.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

bool isAccepted(const Measurements& measurements, const std::vector<std::string>& with,
                const std::vector<std::string>& without, const std::vector<Effect>& effects) {
  try {
    buildModel(measurements, with, without, effects);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

} // namespace

void from_json(const nlohmann::json& json, RequestedPoses& poses) {
  poses = {json.dump(2), {}};
  const auto list = json.find("poses");
  if (list == json.end() || !list->is_array()) {
    return;
  }
  for (const auto& [word, foot] : {std::pair{"left", SupportFoot::left}, std::pair{"right", SupportFoot::right}}) {
    if (std::any_of(list->begin(), list->end(), [word = word](const nlohmann::json& pose) {
          return pose.is_object() && pose.contains("supportFoot") && pose["supportFoot"] == word;
        })) {
      poses.feet.push_back(foot);
    }
  }
}

void from_json(const nlohmann::json& json, CalibrationBoards& boards) {
  boards.boards.clear();
  for (const JsonCursor& place : JsonCursor{json, "boards"}.elements()) {
    boards.boards.push_back(readBoard(place));
  }
  requireDistinctMarkers(boards.boards, JsonCursor{json, "boards"});
}

const std::vector<CalibrationKind>& calibrationKinds() {
  static const std::vector<CalibrationKind> kinds{
      {"head",
       "Quick: head",
       "Neck and cameras, standing on both feet: under a minute. For a robot whose legs are calibrated.",
       {SupportFoot::both}},
      {"left leg",
       "Full: left leg",
       "Left leg, neck and cameras, standing on the left foot: under four minutes.",
       {SupportFoot::left}},
      {"right leg",
       "Full: right leg",
       "Right leg, neck and cameras, standing on the right foot: under four minutes.",
       {SupportFoot::right}},
      {"both legs",
       "Full: both legs",
       "Both legs, neck and cameras, standing on one foot after the other: under eight minutes.",
       {SupportFoot::left, SupportFoot::right}}};
  return kinds;
}

const CalibrationKind* findCalibrationKind(std::string_view run) {
  const auto& kinds = calibrationKinds();
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const CalibrationKind& kind) { return kind.run == run; });
  return found == kinds.end() ? nullptr : &*found;
}

void to_json(nlohmann::json& out, const CalibrationKind& kind) {
  out = {{"run", kind.run}, {"title", kind.title}, {"sentence", kind.sentence}};
}

ModelFile loadCalibrationModel(const std::filesystem::path& configuration, const Robot& drawing) {
  return readModelFile(configuration / "models" / (drawing.model + ".json"), drawing);
}

ReducedModel reduceModel(const Measurements& measurements, const ModelFile& model) {
  ReducedModel fitting{{.effects = model.effects}, {}};
  const bool onOneFoot =
      std::all_of(measurements.stances.begin(), measurements.stances.end(), [](const StanceInstance& standing) {
        return standing.supportFoot == SupportFoot::left || standing.supportFoot == SupportFoot::right;
      });
  if (!onOneFoot) {
    return fitting;
  }
  for (const std::string& pattern : model.with) {
    if (isAccepted(measurements, {pattern}, {}, model.effects)) {
      fitting.model.with.push_back(pattern);
    } else {
      fitting.leftOut.push_back("with " + pattern);
    }
  }
  for (const std::string& pattern : model.without) {
    if (isAccepted(measurements, fitting.model.with, {pattern}, model.effects)) {
      fitting.model.without.push_back(pattern);
    } else {
      fitting.leftOut.push_back("without " + pattern);
    }
  }
  return fitting;
}

} // namespace naocal
