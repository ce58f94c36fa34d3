#include "captures/MarkerDictionary.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace naocal {
namespace {

constexpr std::array<std::pair<std::string_view, int>, 21> dictionaries{{
    {"DICT_4X4_50", 50},        {"DICT_4X4_100", 100},         {"DICT_4X4_250", 250},
    {"DICT_4X4_1000", 1000},    {"DICT_5X5_50", 50},           {"DICT_5X5_100", 100},
    {"DICT_5X5_250", 250},      {"DICT_5X5_1000", 1000},       {"DICT_6X6_50", 50},
    {"DICT_6X6_100", 100},      {"DICT_6X6_250", 250},         {"DICT_6X6_1000", 1000},
    {"DICT_7X7_50", 50},        {"DICT_7X7_100", 100},         {"DICT_7X7_250", 250},
    {"DICT_7X7_1000", 1000},    {"DICT_ARUCO_ORIGINAL", 1024}, {"DICT_APRILTAG_16h5", 30},
    {"DICT_APRILTAG_25h9", 35}, {"DICT_APRILTAG_36h10", 2320}, {"DICT_APRILTAG_36h11", 587},
}};

} // namespace

std::optional<int> markerCount(std::string_view dictionary) {
  const auto entry = std::find_if(dictionaries.begin(), dictionaries.end(),
                                  [&](const auto& candidate) { return candidate.first == dictionary; });
  return entry == dictionaries.end() ? std::nullopt : std::optional{entry->second};
}

} // namespace naocal
