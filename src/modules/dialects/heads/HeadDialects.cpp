#include "dialects/heads/HeadDialects.hpp"

#include "dialects/heads/BitBots.hpp"
#include "dialects/heads/HulksK1.hpp"
#include "dialects/heads/NUbots.hpp"

#include <algorithm>
#include <array>

namespace naocal {

namespace {

constexpr std::array knownHeadDialects{
    HeadDialect{"hulks-k1", "HULKs' Booster K1: camera_matrix_calculator.json5", true, writeHulksK1, parseHulksK1},
    HeadDialect{"bit-bots", "Bit-Bots' Pi+: bitbots_extrinsic_calibration/config/ROBOT.yaml", false, writeBitBots,
                parseBitBots},
    HeadDialect{"nubots", "NUbots' NUgus and K1: Cameras/Left.yaml, K1Sensors.yaml", false, writeNUbots, parseNUbots}};

} // namespace

std::span<const HeadDialect> headDialects() {
  return knownHeadDialects;
}

const HeadDialect* findHeadDialect(std::string_view name) {
  const auto found = std::find_if(knownHeadDialects.begin(), knownHeadDialects.end(),
                                  [&](const HeadDialect& dialect) { return dialect.name == name; });
  return found == knownHeadDialects.end() ? nullptr : &*found;
}

} // namespace naocal
