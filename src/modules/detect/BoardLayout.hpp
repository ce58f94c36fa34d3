#pragma once

#include "captures/Capture.hpp"

#include <Eigen/Core>
#include <array>
#include <optional>

namespace naocal {

/// How many markers a board holds: one in each white square.
int markerCount(const CharucoPattern& pattern);

/// Whether the square lies in black ink; squares count from the top left one, which is black but for the legacy pattern
/// with an even number of rows.
bool isBlack(const CharucoPattern& pattern, int column, int row);

/// Corners of the marker `id` on the board, clockwise from its top left, in squares, y up (the pattern lies at y < 0).
/// Absent when the board does not hold this marker.
std::optional<std::array<Eigen::Vector2d, 4>> markerOnBoard(const CharucoPattern& pattern, int id);

/// Inner corner `id` on the board, in squares, y up.
Eigen::Vector2d cornerOnBoard(const CharucoPattern& pattern, int id);

/// How many inner corners a board has.
int cornerCount(const CharucoPattern& pattern);

/// How far from an inner corner, along the rows and columns, the print mirrors itself in the corner, in squares:
/// the white gap beside a marker and the marker's black border, up to the first cell that depends on the marker.
double symmetricReach(const CharucoPattern& pattern, int cellsPerMarker);

} // namespace naocal
