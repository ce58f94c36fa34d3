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

/// Kinds of problems in a picture that users should know about.
enum class IssueKind {
  wrongImageSize, // the picture's size differs from the camera's; no detection
  wrongPattern,   // the board uses the other layout for even row counts; its corners are not reported
  otherBoard,     // the arrangement of markers contradicts the board's description
  tooFewCorners,  // markers were read, but too few corners confirmed
  falseCorner,    // a corner was found in the wrong position
  hiddenCorner,   // no crossing of four squares at the expected position
  unknownMarkers, // markers that belong to none of the boards
};

struct DetectionIssue {
  IssueKind kind;
  std::string sentence;
  std::string board = {};                    // empty if no board is concerned
  std::optional<int> corner = {};            // falseCorner, hiddenCorner
  std::optional<Eigen::Vector2d> place = {}; // position of that corner [px]
};

struct Detection {
  std::vector<BoardCorners> boards; // detected boards, in the given order
  std::vector<DetectionIssue> findings;
};

/// Detects the inner corners of ChArUco boards in one picture; ignores boards without a pattern.
///
/// Markers identify and locate the boards. Corners are then predicted from those found around them (in undistorted
/// pixels), refined as centres of symmetry (CornerRefinement.hpp) and checked against their neighbours
/// (BoardSearch.hpp). OpenCV's own ChArUco corners are not used, since version 4.6 displaces them by half a pixel.
Detection detectBoards(const GreyPicture& picture, const std::vector<Board>& boards,
                       const CameraIntrinsics& intrinsics);

/// File value of a kind: "wrong-pattern".
std::string toString(IssueKind kind);

/// A problem in the picture of one capture.
struct CaptureIssue {
  int capture = 0; // Capture::id
  DetectionIssue finding;
};

/// Detections in the pictures of a set. All lists are in the order of the captures.
struct SetDetection {
  std::size_t pictures = 0; // number of pictures processed
  std::vector<CaptureIssue> findings;
  std::vector<std::string> unreadable; // one sentence per picture that is missing, broken or of the wrong size
  std::vector<int> unreadableCaptures; // their Capture::id
};

/// Called after each picture with the number done and the total; false stops the detection.
using DetectionProgress = std::function<bool(std::size_t done, std::size_t all)>;

/// Detects the corners anew in every capture of `set` with an image in `folder`, on `threads` threads; the result does
/// not depend on their number. Keeps corners of boards without a pattern, and all corners of captures whose picture is
/// unreadable or was not reached.
SetDetection detectInSet(CaptureSet& set, const std::filesystem::path& folder, unsigned threads,
                         const DetectionProgress& progress);

} // namespace naocal
