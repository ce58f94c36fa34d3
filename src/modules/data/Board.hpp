#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// Where a frame lies in its parent: parentFromFrame = T(x, y, z) Rz(yaw) Ry(pitch) Rx(roll).
struct Placement {
  double x = 0, y = 0, z = 0;          // [m]
  double roll = 0, pitch = 0, yaw = 0; // [rad]
};

/// What is printed on a ChArUco board.
struct CharucoPattern {
  std::string dictionary = "DICT_4X4_100";
  int squaresX = 7, squaresY = 5;
  double squareLength = 0.08, markerLength = 0.06; // [m]
  int firstMarkerId = 0;
  bool legacyPattern = false; // the sheet of OpenCV before 4.6: differs for even squaresY
};

/// A target with numbered corners: a ChArUco board, or single marks when `pattern` is absent.
struct Board {
  std::string id;
  std::string link = "floor"; // where it is fixed: the floor or a link of the robot
  std::optional<CharucoPattern> pattern;
  std::vector<Eigen::Vector3d> points; // pointInBoard by corner id [m]; for a pattern its inner corners
  std::optional<Placement> placement;  // linkFromBoard, surveyed; absent: to be estimated
  Placement placementGuess;            // where the estimate starts, with hasGuess
  bool hasGuess = false;
  std::optional<Placement> placementSigma; // how far off the guess may be (1 sigma); 0 where the file does not say
};

/// Inner corner i of a pattern: ((i mod (squaresX-1)) + 1, -((i div (squaresX-1)) + 1), 0) * squareLength.
std::vector<Eigen::Vector3d> innerCorners(const CharucoPattern& pattern);

/// How many markers a predefined dictionary of OpenCV 4.6 has (their ids are 0 .. count-1); empty for unknown names.
/// Source: opencv2/aruco/dictionary.hpp, PREDEFINED_DICTIONARY_NAME.
std::optional<int> markerCount(std::string_view dictionary);

/// How many markers a board holds: one in each white square.
int markerCount(const CharucoPattern& pattern);

/// Whether the square lies in black ink; squares count from the top left one, which is black but for the legacy pattern
/// with an even number of rows.
bool isBlackSquare(const CharucoPattern& pattern, int column, int row);

/// Corners of the marker `id` on the board, clockwise from its top left, in squares, y up (the pattern lies at y < 0).
/// Absent when the board does not hold this marker.
std::optional<std::array<Eigen::Vector2d, 4>> markerOnBoard(const CharucoPattern& pattern, int id);

/// Inner corner `id` on the board, in squares, y up.
Eigen::Vector2d cornerOnBoard(const CharucoPattern& pattern, int id);

/// How many inner corners a board has.
int cornerCount(const CharucoPattern& pattern);

/// How far from an inner corner, along the rows and columns, the print mirrors itself in the corner, in squares:
/// the white gap beside a marker and the marker's black border, up to the first cell that depends on the marker.
double symmetryRadius(const CharucoPattern& pattern, int cellsPerMarker);

} // namespace naocal
