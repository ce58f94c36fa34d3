#include "TemporaryFolder.hpp"

#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "print/PrintedBoards.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace naocal;

namespace {

PrintedBoard defaultBoard() {
  Board board;
  board.id = "A";
  board.pattern = CharucoPattern{};
  board.points = innerCorners(*board.pattern);
  return {board, *board.pattern, std::nullopt};
}

std::string refusalOf(const PrintedRulers& rulers) {
  PrintedBoard board = defaultBoard();
  try {
    setMeasuredSize(board, rulers);
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

} // namespace

TEST_CASE("a measured ruler scales squares, markers and corners alike") {
  // Proves: the size is the mean of both directions, and measuring twice does not scale twice.
  PrintedBoard board = defaultBoard();
  for (int times = 0; times < 2; ++times) {
    setMeasuredSize(board, {0.1990, 0.1992});
    CHECK(board.board.pattern->squareLength == Approx(0.08 * 0.9955).epsilon(1e-12));
    CHECK(board.board.pattern->markerLength == Approx(0.06 * 0.9955).epsilon(1e-12));
    CHECK(board.board.points[0].x() == Approx(0.08 * 0.9955).epsilon(1e-12));
    CHECK(board.drawn.squareLength == 0.08);
  }
}

TEST_CASE("implausible measurements are refused") {
  // Proves: millimetres, another length, and two directions that differ are each refused with the reason.
  CHECK(refusalOf({199.5, 199.5}).find("give metres: 0.1995") != std::string::npos);
  CHECK(refusalOf({0.56, 0.4}).find("not the pattern") != std::string::npos);
  CHECK(refusalOf({0.2, 0.1985}).find("one scale in both directions") != std::string::npos);
  CHECK(refusalOf({0.2, 0.1995}) == "not refused");
}

TEST_CASE("a boards file keeps the drawn and the real size, and what else it holds") {
  // Proves: written and read again, both sizes and the measurement are the same; unknown keys survive.
  const TemporaryFolder folder;
  const auto file = folder.path() / "boards.json";
  PrintedBoard board = defaultBoard();
  setMeasuredSize(board, {0.1995, 0.1995});
  nlohmann::json written = printedBoardsJson({board}, nullptr);
  written["note"] = "kept";
  written["boards"][0]["colour"] = "black";
  writeAtomically(file, written.dump());
  const auto read = readPrintedBoards(file);
  REQUIRE(read.size() == 1);
  CHECK(read[0].drawn.squareLength == 0.08);
  CHECK(read[0].board.pattern->squareLength == Approx(0.0798).epsilon(1e-12));
  REQUIRE(read[0].measured);
  CHECK(read[0].measured->alongColumns == 0.1995);
  const nlohmann::json again = printedBoardsJson(read, readBoardList(file).source);
  CHECK(again == written);
}
