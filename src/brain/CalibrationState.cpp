#include "brain/CalibrationState.hpp"

#include <array>
#include <nlohmann/json.hpp>

namespace naocal {

void to_json(nlohmann::json& out, const CalibrationState& state) {
  constexpr std::array names{"idle", "going home", "moving", "collecting", "solving", "checking", "finished", "failed"};
  out = {{"phase", names[static_cast<std::size_t>(state.phase)]},
         {"sentence", state.sentence},
         {"pose", state.pose},
         {"poses", state.poses},
         {"captures", state.captures},
         {"secondsLeft", state.secondsLeft ? nlohmann::json(*state.secondsLeft) : nlohmann::json()},
         {"errorBefore", state.errorBefore ? nlohmann::json(*state.errorBefore) : nlohmann::json()},
         {"errorAfter", state.errorAfter ? nlohmann::json(*state.errorAfter) : nlohmann::json()}};
}

} // namespace naocal
