#pragma once

#include "data/Capture.hpp"
#include "io/GreyImage.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// What a person should know about a picture, beyond the corners.
enum class IssueKind {
  wrongImageSize, // the picture is not of the size that its camera is said to have; nothing was looked for
  wrongPattern,   // the board is printed in the other pattern for even row counts; its corners are not reported
  otherBoard,     // its markers lie otherwise than on the board that is described
  tooFewCorners,  // markers were read, but not enough corners could be confirmed
  falseCorner,    // something like a corner is there, but in the wrong place
  hiddenCorner,   // a corner should be there, and no crossing of four squares is
  unknownMarkers, // markers that belong to none of the boards
};

struct DetectionIssue {
  IssueKind kind;
  std::string sentence;
  std::string board = {};                    // empty where it is about no board
  std::optional<int> corner = {};            // falseCorner, hiddenCorner
  std::optional<Eigen::Vector2d> place = {}; // of that corner [px]
};

struct Detection {
  std::vector<BoardCorners> boards; // those that were found, in the order given
  std::vector<DetectionIssue> findings;
};

/// The inner corners of ChArUco boards in one picture; boards without a pattern are passed over.
///
/// Markers tell which board lies where. Corners are then predicted from what was found around them (in undistorted
/// pixels), fitted as centres of symmetry (CornerFit.hpp) and checked against their neighbours (BoardSearch.hpp).
/// OpenCV's own ChArUco corners, half a pixel off in version 4.6, are not used.
Detection detectBoards(const GreyPicture& picture, const std::vector<Board>& boards,
                       const CameraIntrinsics& intrinsics);

/// A finding's kind as it stands in files: "wrong-pattern".
std::string toString(IssueKind kind);

/// What a person should know about one capture's picture.
struct CaptureIssue {
  int capture = 0; // Capture::id
  DetectionIssue finding;
};

/// What came of looking through a set's pictures. All lists are in the order of the captures.
struct SetDetection {
  std::size_t pictures = 0; // that were looked at
  std::vector<CaptureIssue> findings;
  std::vector<std::string> unreadable; // one sentence per picture that is missing, broken or of the wrong size
};

/// Told after each picture how many of how many are done; false stops the search.
using DetectionProgress = std::function<bool(std::size_t done, std::size_t all)>;

/// Finds the corners anew in every capture of `set` that names an image in `folder`, on `threads` threads; the result
/// does not depend on their number. Corners of boards without a pattern are kept, and so are all corners of captures
/// whose picture is unreadable or was not reached.
SetDetection detectInSet(CaptureSet& set, const std::filesystem::path& folder, unsigned threads,
                         const DetectionProgress& progress);

} // namespace naocal
