#pragma once

#include "data/Board.hpp"

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

namespace naocal {

/// Format of a boards file.
inline constexpr std::string_view boardListFormat = "naocal-boards";

/// A boards file: {"format": "naocal-boards", "version": 1, "boards": [...]}, with entries as in a capture set.
struct BoardListFile {
  std::vector<Board> boards;
  std::shared_ptr<const nlohmann::json> source; // as read; preserves unknown keys
};

/// Reads a boards file. Throws InputError for another format, an invalid or a repeated board, or shared markers.
BoardListFile readBoardList(const std::filesystem::path& file);

/// Reads the boards of a boards file, or of a capture set if `place` is a folder. Throws InputError.
std::vector<Board> readBoards(const std::filesystem::path& place);

/// Those of them that lie on the floor; a guessed placement counts as the placement. Throws InputError if there are
/// none.
std::vector<Board> readFloorBoards(const std::filesystem::path& place);

/// The file's JSON; preserves unknown keys that were read.
nlohmann::ordered_json toJson(const BoardListFile& list);

} // namespace naocal
