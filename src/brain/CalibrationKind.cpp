#include "brain/CalibrationKind.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal {

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

const CalibrationKind* calibrationKind(std::string_view run) {
  const auto& kinds = calibrationKinds();
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const CalibrationKind& kind) { return kind.run == run; });
  return found == kinds.end() ? nullptr : &*found;
}

void to_json(nlohmann::json& out, const CalibrationKind& kind) {
  out = {{"run", kind.run}, {"title", kind.title}, {"sentence", kind.sentence}};
}

} // namespace naocal
