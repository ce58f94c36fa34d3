#include "motion/Lights.hpp"

namespace naocal {

Leds lights(const PlayerState& player) {
  using Phase = PlayerState::Phase;
  constexpr Rgb dark{}, white{0.5f, 0.5f, 0.5f}, red{1, 0, 0};
  const Rgb eyes = player.phase == Phase::fallen ? red
                   : player.phase == Phase::off  ? dark
                   : player.held                 ? holdMe
                                                 : white;
  Leds leds;
  leds.leftEye.fill(eyes);
  leds.rightEye.fill(eyes);
  return leds;
}

} // namespace naocal
