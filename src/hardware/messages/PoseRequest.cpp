#include "hardware/messages/PoseRequest.hpp"

#include <array>
#include <nlohmann/json.hpp>

namespace naocal {

void to_json(nlohmann::json& out, const PlayerState& state) {
  constexpr std::array names{"off", "moving", "holding", "fallen"};
  out = {{"phase", names[static_cast<std::size_t>(state.phase)]},
         {"request", state.request},
         {"held", state.held},
         {"done", state.done},
         {"atHome", state.atHome},
         {"progress", state.progress},
         {"secondsLeft", state.secondsLeft},
         {"reason", state.reason}};
}

} // namespace naocal
