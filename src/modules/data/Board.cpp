#include "data/Board.hpp"

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

int markerCount(const CharucoPattern& pattern) {
  return pattern.squaresX * pattern.squaresY / 2;
}

bool isBlackSquare(const CharucoPattern& pattern, int column, int row) {
  const bool firstIsBlack = !pattern.legacyPattern || pattern.squaresY % 2 != 0;
  return ((column + row) % 2 == 0) == firstIsBlack;
}

std::optional<std::array<Eigen::Vector2d, 4>> markerOnBoard(const CharucoPattern& pattern, int id) {
  int next = pattern.firstMarkerId;
  for (int row = 0; row < pattern.squaresY; ++row) {
    for (int column = 0; column < pattern.squaresX; ++column) {
      if (!isBlackSquare(pattern, column, row) && next++ == id) {
        const Eigen::Vector2d centre{column + 0.5, -(row + 0.5)};
        const double h = pattern.markerLength / pattern.squareLength / 2;
        return std::array<Eigen::Vector2d, 4>{centre + Eigen::Vector2d{-h, h}, centre + Eigen::Vector2d{h, h},
                                              centre + Eigen::Vector2d{h, -h}, centre + Eigen::Vector2d{-h, -h}};
      }
    }
  }
  return std::nullopt;
}

Eigen::Vector2d cornerOnBoard(const CharucoPattern& pattern, int id) {
  const int perRow = pattern.squaresX - 1;
  return {id % perRow + 1, -(id / perRow + 1)};
}

int cornerCount(const CharucoPattern& pattern) {
  return (pattern.squaresX - 1) * (pattern.squaresY - 1);
}

double symmetryRadius(const CharucoPattern& pattern, int cellsPerMarker) {
  const double marker = pattern.markerLength / pattern.squareLength;
  return (1 - marker) / 2 + marker / cellsPerMarker;
}

std::vector<Eigen::Vector3d> innerCorners(const CharucoPattern& pattern) {
  std::vector<Eigen::Vector3d> corners;
  for (int id = 0; id < cornerCount(pattern); ++id) {
    const Eigen::Vector2d corner = pattern.squareLength * cornerOnBoard(pattern, id);
    corners.emplace_back(corner.x(), corner.y(), 0);
  }
  return corners;
}

} // namespace naocal
