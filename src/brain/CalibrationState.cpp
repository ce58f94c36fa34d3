#include "brain/CalibrationState.hpp"

#include <array>
#include <nlohmann/json.hpp>

namespace naocal {

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

} // namespace naocal
