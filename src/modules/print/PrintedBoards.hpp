#pragma once

#include "data/BoardListFile.hpp"
#include "print/BoardSheet.hpp"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

namespace naocal {

/// A board with the pattern that was drawn for it. Its own pattern has the size of the real print.
struct PrintedBoard {
  Board board;
  CharucoPattern drawn;
  std::optional<PrintedRulers> measured; // lengths of the rulers on the print; absent: taken as drawn
};

/// Sets the board's pattern and corners to the size that the rulers of the print have: the mean of both directions.
/// Throws InputError for lengths that differ from the drawn ones by more than 20 %, or from each other by more than
/// 0.5 % (a board has one size).
void setMeasuredSize(PrintedBoard& board, const PrintedRulers& measured);

/// Boards of a boards file. A board that was never printed by naocal counts as drawn in its present size. Throws
/// InputError for an invalid file, or a board without a ChArUco pattern.
std::vector<PrintedBoard> readPrintedBoards(const std::filesystem::path& file);

/// The boards file for printed boards; `read`: the file to update, whose unknown keys are preserved, or null. Each
/// entry gets the key `printed`: {"squareLength", "markerLength"} as drawn, and "rulers" as measured [m].
nlohmann::json printedBoardsJson(const std::vector<PrintedBoard>& boards, std::shared_ptr<const nlohmann::json> read);

} // namespace naocal
