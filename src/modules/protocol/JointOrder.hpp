#pragma once

#include <array>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace naocal {

/// The joints of a NAO in HULKs' order, used by every list in src/hardware, src/motion and src/brain. The right hip
/// yaw-pitch has its own entry although one motor drives both; hands are 0 (closed) to 1 (open). Source: HULKs code
/// release 2019, Modules/NaoProvider.h.
inline constexpr std::array<std::string_view, 26> jointNames{
    "HeadYaw",       "HeadPitch",    "LShoulderPitch", "LShoulderRoll", "LElbowYaw",   "LElbowRoll",  "LWristYaw",
    "LHand",         "LHipYawPitch", "LHipRoll",       "LHipPitch",     "LKneePitch",  "LAnklePitch", "LAnkleRoll",
    "RHipYawPitch",  "RHipRoll",     "RHipPitch",      "RKneePitch",    "RAnklePitch", "RAnkleRoll",  "RShoulderPitch",
    "RShoulderRoll", "RElbowYaw",    "RElbowRoll",     "RWristYaw",     "RHand"};

inline constexpr std::size_t jointCount = jointNames.size();

/// Largest offset that a robot accepts, both ways [deg]; 11.5 have been observed.
inline constexpr double largestOffset = 30;

/// Index of a joint in `jointNames`; absent for an unknown name.
constexpr std::optional<std::size_t> jointIndex(std::string_view name) {
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    if (jointNames[joint] == name) {
      return joint;
    }
  }
  return std::nullopt;
}

/// Key of a joint's offset in HULKs' configuration: its name with a lower-case first letter.
inline std::string offsetKey(std::string_view joint) {
  std::string key{joint};
  key[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(key[0])));
  return key;
}

} // namespace naocal
