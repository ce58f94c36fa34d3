#include "brain/BehaviorModule.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

void to_json(nlohmann::json& out, const HeadLookRequest& look) {
  out = {{"active", look.active}, {"yaw", look.yaw}, {"pitch", look.pitch}};
}

} // namespace naocal
