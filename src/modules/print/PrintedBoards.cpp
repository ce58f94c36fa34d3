#include "print/PrintedBoards.hpp"

#include "data/BoardFile.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

constexpr double largestDeviation = 0.2;    // of a ruler's length: more is another unit, or another ruler
constexpr double largestDifference = 0.005; // between both directions

/// Real length over drawn length of one ruler.
double scaleOf(const PrintedBoard& board, double measured, double drawn, const char* direction) {
  const double scale = measured / drawn;
  if (std::abs(scale - 1) <= largestDeviation) {
    return scale;
  }
  const bool isMillimetres = std::abs(scale / 1000 - 1) <= largestDeviation;
  throw InputError{
      fmt::format("--measured, board {}, {}: expected the length of the printed ruler of {:g} m, within 20 %, "
                  "found {:g} m{}",
                  board.board.id, direction, drawn, measured,
                  isMillimetres ? fmt::format("; give metres: {:g}", measured / 1000)
                                : "; measure the ruler beside the pattern, not the pattern")};
}

} // namespace

void setMeasuredSize(PrintedBoard& board, const PrintedRulers& measured) {
  const PrintedRulers drawn = printedRulers(board.drawn);
  const double alongRows = scaleOf(board, measured.alongRows, drawn.alongRows, "along the rows"),
               alongColumns = scaleOf(board, measured.alongColumns, drawn.alongColumns, "along the columns");
  const double scale = (alongRows + alongColumns) / 2;
  if (std::abs(alongRows - alongColumns) > largestDifference * scale) {
    throw InputError{
        fmt::format("--measured, board {}: expected one scale in both directions, within 0.5 %, found {:.2f} % "
                    "along the rows and {:.2f} % along the columns; measure again, or print on another "
                    "printer",
                    board.board.id, 100 * alongRows, 100 * alongColumns)};
  }
  CharucoPattern pattern = board.drawn;
  pattern.squareLength *= scale;
  pattern.markerLength *= scale;
  board.board.pattern = pattern;
  board.board.points = innerCorners(pattern);
  board.measured = measured;
}

std::vector<PrintedBoard> readPrintedBoards(const std::filesystem::path& file) {
  const BoardListFile list = readBoardList(file);
  const auto places = JsonCursor{*list.source, file.string()}.at("boards").elements();
  std::vector<PrintedBoard> boards;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Board& board = list.boards[i];
    if (!board.pattern) {
      places[i].refuse("a ChArUco board, as other targets are not printed", "single marks");
    }
    PrintedBoard printed{board, *board.pattern, std::nullopt};
    if (const auto given = places[i].find("printed")) {
      printed.drawn.squareLength = given->at("squareLength").number(positiveLengthRange);
      printed.drawn.markerLength = given->at("markerLength").number({1e-6, printed.drawn.squareLength, "m"});
      if (const auto rulers = given->find("rulers")) {
        const auto lengths = rulers->numbers(2, positiveLengthRange, "along the rows, along the columns");
        printed.measured = {lengths[0], lengths[1]};
      }
    }
    boards.push_back(printed);
  }
  return boards;
}

nlohmann::json printedBoardsJson(const std::vector<PrintedBoard>& boards, std::shared_ptr<const nlohmann::json> read) {
  BoardListFile list{{}, std::move(read)};
  for (const PrintedBoard& board : boards) {
    list.boards.push_back(board.board);
  }
  nlohmann::json json = toJson(list);
  for (std::size_t i = 0; i < boards.size(); ++i) {
    nlohmann::json& printed = json["boards"][i]["printed"];
    printed["squareLength"] = boards[i].drawn.squareLength;
    printed["markerLength"] = boards[i].drawn.markerLength;
    if (const auto& rulers = boards[i].measured) {
      printed["rulers"] = {rulers->alongRows, rulers->alongColumns};
    } else {
      printed.erase("rulers");
    }
  }
  return json;
}

} // namespace naocal
