#include "data/BoardListFile.hpp"

#include "data/BoardFile.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "io/JsonWriter.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

BoardListFile readBoardList(const std::filesystem::path& file) {
  BoardListFile list;
  list.source = std::make_shared<const nlohmann::json>(parseJson(readFile(file), file.string()));
  const JsonCursor top{*list.source, file.string()};
  requireFormat(top, boardListFormat);
  const JsonCursor boards = top.at("boards");
  for (const JsonCursor& place : boards.elements()) {
    Board board = readBoard(place);
    if (std::any_of(list.boards.begin(), list.boards.end(), [&](const Board& other) { return other.id == board.id; })) {
      place.at("id").refuse("an id that no other board has");
    }
    list.boards.push_back(std::move(board));
  }
  if (list.boards.empty()) {
    boards.refuse("at least one board", "none");
  }
  requireDistinctMarkers(list.boards, boards);
  return list;
}

std::vector<Board> readBoards(const std::filesystem::path& place) {
  return std::filesystem::is_directory(place) ? readCaptureSet(place, BadCapturePolicy::skip).set.boards
                                              : readBoardList(place).boards;
}

std::vector<Board> readFloorBoards(const std::filesystem::path& place) {
  std::vector<Board> boards = readBoards(place);
  std::erase_if(boards, [](const Board& board) { return board.link != "floor"; });
  if (boards.empty()) {
    throw InputError{fmt::format("{}: expected a board on the floor, found none", place.string())};
  }
  for (Board& board : boards) {
    board.placement = board.placement || !board.hasGuess ? board.placement : board.placementGuess;
  }
  return boards;
}

nlohmann::ordered_json toJson(const BoardListFile& list) {
  const nlohmann::json none;
  const nlohmann::json& read = list.source ? *list.source : none;
  nlohmann::ordered_json boards = nlohmann::ordered_json::array();
  for (const Board& board : list.boards) {
    boards.push_back(toJson(board, entryOrNull("id", board.id, childOrNull(read, "boards"))));
  }
  return mergeUnknownKeys(withFormatInOrder(boardListFormat, nlohmann::ordered_json{{"boards", boards}}), read);
}

} // namespace naocal
