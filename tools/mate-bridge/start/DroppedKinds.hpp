#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace naocal {

/// What a dropped file is, by the ending of its name.
enum class DroppedKind {
  document,    // a capture set, a result, boards, a column map
  robot,       // a description
  table,       // of joint angles
  lens,        // a calibration
  picture,     // one that naocal decodes
  otherPicture // one that a capture set may name, but that is not decoded
};

/// Absent for a file that is none of them. Capitals do not count.
std::optional<DroppedKind> droppedKindOf(const std::string& name);

/// All endings of names of files that may be dropped, in words: ".json, .urdf, ..".
std::string droppedEndings();

/// Whether the file holds the truth of a simulated set, which is never opened.
bool isDroppedTruth(const std::string& name);

/// What the page needs to know before it sends files: {"endings": all, "endingsOfSet": those of files that belong to a
/// capture set, "endingOfTruth": of files that are not sent, "mostFiles", "mostBytes": of one drop, "expected": what to
/// drop, in words}. Endings are in small letters.
nlohmann::json droppedFilesState();

/// What can be opened or imported, in words.
inline constexpr const char* expectedDrop =
    "a folder with captures.json, a recording, a result with its captures, or a table (.csv) with its robot's URDF";

} // namespace naocal
