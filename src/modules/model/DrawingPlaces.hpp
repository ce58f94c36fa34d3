#pragma once

#include "captures/JsonPlace.hpp"
#include "model/Robot.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace naocal {

// What the parts of the drawing's reader share.

inline constexpr Range millimetreRange{-10000, 10000, "millimetres"};
inline constexpr Range degreeRange{-360, 360, "degrees"};
inline constexpr Range directionRange{-1, 1, ""};

/// The entries of an object but its "source" and "note", which are allowed everywhere and are for people only.
std::vector<std::pair<std::string, JsonPlace>> entries(const JsonPlace& place);

/// The entries of a section of the drawing; none when it is absent.
std::vector<std::pair<std::string, JsonPlace>> section(const JsonPlace& drawing, const std::string& key);

/// A misspelt optional key would silently change the robot: every key must be one of these.
void allowOnly(const JsonPlace& place, const std::vector<std::string_view>& keys);

Eigen::Vector3d vector3(const JsonPlace& place, const Range& range);
Eigen::Vector3d metres3(const JsonPlace& millimetres);
Eigen::Vector2d metres2(const JsonPlace& millimetres);

/// The link or joint of which this place holds the name.
std::size_t linkAt(const JsonPlace& place, const Robot& robot);
std::size_t jointAt(const JsonPlace& place, const Robot& robot);

/// The drawing's sections "joints" and "soles", for a robot whose tree is known.
void readJoints(const JsonPlace& drawing, Robot& robot);
void readSoles(const JsonPlace& drawing, Robot& robot);

} // namespace naocal
