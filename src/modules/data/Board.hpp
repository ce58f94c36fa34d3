#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// Placement of a frame in its parent: parentFromFrame = T(x, y, z) Rz(yaw) Ry(pitch) Rx(roll).
struct Placement {
  double x = 0, y = 0, z = 0;          // [m]
  double roll = 0, pitch = 0, yaw = 0; // [rad]

  /// (x, y, z, roll, pitch, yaw), as `transformFromPlacement` and the state take it.
  Eigen::Matrix<double, 6, 1> numbers() const {
    return (Eigen::Matrix<double, 6, 1>{} << x, y, z, roll, pitch, yaw).finished();
  }
};

/// The printed pattern of a ChArUco board.
struct CharucoPattern {
  std::string dictionary = "DICT_4X4_100";
  int squaresX = 7, squaresY = 5;
  double squareLength = 0.08, markerLength = 0.06; // [m]
  int firstMarkerId = 0;
  bool legacyPattern = false; // layout of OpenCV before 4.6; differs for even squaresY
};

/// A target with numbered corners: a ChArUco board, or single marks if `pattern` is absent.
struct Board {
  std::string id;
  std::string link = "floor"; // "floor", or the robot link it is fixed to
  std::optional<CharucoPattern> pattern;
  std::vector<Eigen::Vector3d> points; // pointInBoard by corner id [m]; for a pattern its inner corners
  std::optional<Placement> placement;  // surveyed linkFromBoard; absent: to be estimated
  Placement placementGuess;            // initial value of the estimate, if hasGuess
  bool hasGuess = false;
  std::optional<Placement> placementSigma; // 1 sigma of the guess; 0 where not given in the file
};

/// Inner corner i of a pattern: ((i mod (squaresX-1)) + 1, -((i div (squaresX-1)) + 1), 0) * squareLength.
std::vector<Eigen::Vector3d> innerCorners(const CharucoPattern& pattern);

/// Number of markers of a predefined dictionary of OpenCV 4.6 (ids 0 .. count-1); empty for unknown names. Source:
/// opencv2/aruco/dictionary.hpp, PREDEFINED_DICTIONARY_NAME.
std::optional<int> markerCount(std::string_view dictionary);

/// Number of markers on a board: one per white square.
int markerCount(const CharucoPattern& pattern);

/// Whether the square is black. Squares count from the top left one, which is black except in the legacy pattern with
/// an even number of rows.
bool isBlackSquare(const CharucoPattern& pattern, int column, int row);

/// Corners of marker `id` on the board, clockwise from its top left, in squares, y up (the pattern lies at y < 0).
/// Absent if the board lacks the marker.
std::optional<std::array<Eigen::Vector2d, 4>> markerOnBoard(const CharucoPattern& pattern, int id);

/// Position of inner corner `id` on the board, in squares, y up.
Eigen::Vector2d cornerOnBoard(const CharucoPattern& pattern, int id);

/// Number of inner corners of a board.
int cornerCount(const CharucoPattern& pattern);

/// Radius of point symmetry of the print about an inner corner, along rows and columns, in squares: the white gap
/// beside a marker plus the marker's black border, up to the first cell that depends on the marker.
double symmetryRadius(const CharucoPattern& pattern, int cellsPerMarker);

} // namespace naocal
