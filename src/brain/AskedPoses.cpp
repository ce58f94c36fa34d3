#include "brain/AskedPoses.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal {

void from_json(const nlohmann::json& json, AskedPoses& poses) {
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

} // namespace naocal
