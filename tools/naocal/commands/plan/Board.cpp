#include "commands/Commands.hpp"
#include "console/OutputFiles.hpp"
#include "console/PdfFiles.hpp"
#include "console/print/PrintText.hpp"

#include "command-line/OptionChecks.hpp"
#include "data/BoardFile.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "print/BoardSheet.hpp"
#include "print/PrintedBoards.hpp"
#include "simulation/SimulationPlan.hpp"

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace naocal {

namespace {

/// Options of `naocal board`.
struct BoardCommand {
  std::string output, boardsFile, paper = "a2", tile, squares = "7x5", dictionary = "DICT_4X4_100";
  std::vector<std::string> ids{"A", "B", "C", "D"}, only;
  std::vector<double> measured;
  double squareMillimetres = 0, markerMillimetres = 0; // 0: as the paper allows
  int firstMarker = 0;
  bool legacy = false, describesPattern = false;

  void run() const;

private:
  CharucoPattern pattern() const;
  std::vector<PrintedBoard> makeBoards() const;
  std::set<std::string> selectedIds(const std::vector<PrintedBoard>& boards) const;
  void measure(std::vector<PrintedBoard>& boards, const std::set<std::string>& selected) const;
  void print(const std::vector<PrintedBoard>& boards, const std::set<std::string>& selected) const;
};

/// The pattern that the options describe; squares as large as the paper allows unless given.
CharucoPattern BoardCommand::pattern() const {
  CharucoPattern result;
  char end = 0;
  if (std::sscanf(squares.c_str(), "%dx%d%c", &result.squaresX, &result.squaresY, &end) != 2 || result.squaresX < 2 ||
      result.squaresY < 2 || result.squaresX > 100 || result.squaresY > 100) {
    throw InputError{
        fmt::format("--squares: expected COLUMNSxROWS, each from 2 to 100, such as 7x5, found {}", squares)};
  }
  result.dictionary = dictionary;
  result.firstMarkerId = firstMarker;
  result.legacyPattern = legacy;
  if (squareMillimetres > 0) {
    result.squareLength = squareMillimetres / 1000;
    result.markerLength = 0.75 * result.squareLength;
  } else {
    result = fitToPaper(result, findPaper(paper));
  }
  if (markerMillimetres > 0) {
    result.markerLength = markerMillimetres / 1000;
  }
  return result;
}

/// Boards as the options describe them, with markers one board after the other. Where ids are those of the default
/// boards, they lie about there.
std::vector<PrintedBoard> BoardCommand::makeBoards() const {
  CharucoPattern next = pattern();
  const std::vector<Board> usual = defaultBoards();
  nlohmann::json list = nlohmann::json::array();
  for (const std::string& id : ids) {
    Board board;
    board.id = id;
    board.pattern = next;
    board.points = innerCorners(next);
    const auto like = std::find_if(usual.begin(), usual.end(), [&](const Board& each) { return each.id == id; });
    if (like != usual.end()) {
      const auto half = [](const CharucoPattern& each) -> Eigen::Vector2d {
        return each.squareLength / 2 * Eigen::Vector2d{each.squaresX, -each.squaresY};
      };
      const Placement& place = *like->placement;
      const Eigen::Vector2d corner =
          Eigen::Vector2d{place.x, place.y} + Eigen::Rotation2Dd{place.yaw} * (half(*like->pattern) - half(next));
      board.placementGuess = {.x = corner.x(), .y = corner.y(), .yaw = place.yaw};
      board.hasGuess = true;
    }
    list.push_back(nlohmann::json(toJson(board, nullptr)));
    next.firstMarkerId += markerCount(next);
  }
  const JsonCursor place{list, "naocal board"};
  std::vector<PrintedBoard> result;
  std::vector<Board> boards;
  for (const JsonCursor& entry : place.elements()) {
    boards.push_back(readBoard(entry)); // refuses unknown dictionaries, too few markers, markers as large as squares
    result.push_back({boards.back(), *boards.back().pattern, std::nullopt});
  }
  requireDistinctMarkers(boards, place);
  return result;
}

std::set<std::string> BoardCommand::selectedIds(const std::vector<PrintedBoard>& boards) const {
  std::set<std::string> all;
  for (const PrintedBoard& board : boards) {
    if (!all.insert(board.board.id).second) {
      throw InputError{fmt::format("--ids: expected every id once, found {} twice", board.board.id)};
    }
  }
  for (const std::string& id : only) {
    if (!all.contains(id)) {
      throw InputError{fmt::format("--only: expected ids among {}, found {}", fmt::join(all, ", "), id)};
    }
  }
  return only.empty() ? all : std::set<std::string>{only.begin(), only.end()};
}

void BoardCommand::measure(std::vector<PrintedBoard>& boards, const std::set<std::string>& selected) const {
  const PrintedRulers rulers{measured.front(), measured.back()};
  for (PrintedBoard& board : boards) {
    if (selected.contains(board.board.id)) {
      setMeasuredSize(board, rulers);
      const CharucoPattern& real = *board.board.pattern;
      printText("board {}: squares of {:.3f} mm, markers of {:.3f} mm ({:+.2f} %)\n", board.board.id,
                1000 * real.squareLength, 1000 * real.markerLength,
                100 * (real.squareLength / board.drawn.squareLength - 1));
    }
  }
}

void BoardCommand::print(const std::vector<PrintedBoard>& boards, const std::set<std::string>& selected) const {
  PdfDocument pdf{boardPdfCreator, "ChArUco boards for naocal"};
  std::vector<std::string> lines;
  for (const PrintedBoard& printed : boards) {
    if (!selected.contains(printed.board.id)) {
      continue;
    }
    Board board = printed.board;
    board.pattern = printed.drawn;
    std::size_t sheets = 1;
    if (tile.empty()) {
      addBoardSheet(pdf, board, findPaper(paper));
    } else {
      sheets = addBoardTiles(pdf, board, findPaper(tile));
    }
    const CharucoPattern& pattern = printed.drawn;
    lines.push_back(fmt::format("board {}: {} × {} squares of {:g} mm, {} {} to {}, {} sheet{} of {}", board.id,
                                pattern.squaresX, pattern.squaresY, 1000 * pattern.squareLength, pattern.dictionary,
                                pattern.firstMarkerId, pattern.firstMarkerId + markerCount(pattern) - 1, sheets,
                                sheets == 1 ? "" : "s", tile.empty() ? paper : tile));
  }
  writePdf(output, pdf.finish(), boardPdfCreator);
  printText("{}\n{} is written: print it at 100 %, and measure both rulers of each board\n", fmt::join(lines, "\n"),
            output);
}

void BoardCommand::run() const {
  if (output.empty() && boardsFile.empty()) {
    throw InputError{"expected -o BOARD.pdf to print, or --boards FILE to keep a measured size, found neither"};
  }
  if (!measured.empty() && boardsFile.empty()) {
    throw InputError{"--measured: expected --boards FILE, which keeps the real size, found none"};
  }
  const bool isThere = !boardsFile.empty() && std::filesystem::exists(boardsFile);
  if (isThere && describesPattern) {
    throw InputError{
        fmt::format("{}: expected a new file for other boards, found the boards that it holds; leave --ids and "
                    "the options of the pattern away, or name another file",
                    boardsFile)};
  }
  std::vector<PrintedBoard> boards = isThere ? readPrintedBoards(boardsFile) : makeBoards();
  const std::set<std::string> selected = selectedIds(boards);
  if (!measured.empty()) {
    measure(boards, selected);
  }
  if (!output.empty()) {
    print(boards, selected);
  }
  if (!boardsFile.empty()) {
    const auto read = isThere ? readBoardList(boardsFile).source : nullptr;
    writeJson(printedBoardsJson(boards, read), boardsFile);
    printText("{} holds the boards: give it to import, poses, simulate and naocal-robot with --boards\n", boardsFile);
  }
}

} // namespace

void addBoard(CLI::App& app) {
  const auto command = std::make_shared<BoardCommand>();
  CLI::App* const board = app.get_subcommand("board");
  board->add_option("-o,--output", command->output, "BOARD.pdf, to be written: one page per board, or sheet of it")
      ->type_name("FILE")
      ->check(replaceablePdf(boardPdfCreator));
  board
      ->add_option("--boards", command->boardsFile,
                   "boards file to draw; it is written if it does not exist, and holds the real sizes")
      ->type_name("FILE")
      ->check(replaceableFile(std::string{boardListFormat}));
  board
      ->add_option("--measured", command->measured,
                   "real lengths of the two rulers on the print [m], along the rows and along the columns, such as "
                   "0.1995,0.1990; of one alone: for both; needs --boards")
      ->type_name("METRES")
      ->delimiter(',')
      ->expected(1, 2)
      ->check(positiveNumber());
  board->add_option("--only", command->only, "ids of the boards to print or measure; default: all")
      ->type_name("IDS")
      ->delimiter(',');
  board->add_option("--paper", command->paper, "of the sheet, and so of the squares: a4, a3, a2, a1 or a0")
      ->type_name("SIZE")
      ->capture_default_str();
  board->add_option("--tile", command->tile, "spread each board over several sheets of this paper, such as a4")
      ->type_name("SIZE");
  std::vector<CLI::Option*> ofPattern{
      board->add_option("--ids", command->ids, "of the boards to draw, one page each")
          ->type_name("IDS")
          ->delimiter(',')
          ->capture_default_str(),
      board->add_option("--squares", command->squares, "of a board")->type_name("COLUMNSxROWS")->capture_default_str(),
      board
          ->add_option("--square-millimetres", command->squareMillimetres,
                       "side of a square; default: as large as the paper allows")
          ->check(number(5.0, 1000.0)),
      board
          ->add_option("--marker-millimetres", command->markerMillimetres,
                       "side of a marker; default: three quarters of a square")
          ->group(expertOptions)
          ->check(number(1.0, 1000.0)),
      board->add_option("--dictionary", command->dictionary, "of markers, one of OpenCV's")
          ->type_name("NAME")
          ->group(expertOptions)
          ->capture_default_str(),
      board->add_option("--first-marker", command->firstMarker, "of the first board; the others' follow")
          ->group(expertOptions)
          ->check(wholeNumber(0, 1000))
          ->capture_default_str(),
      board->add_flag("--legacy", command->legacy, "layout of OpenCV before 4.6, which differs for even row counts")
          ->group(expertOptions)};
  board->callback([command, ofPattern] {
    command->describesPattern =
        std::any_of(ofPattern.begin(), ofPattern.end(), [](const CLI::Option* option) { return option->count() > 0; });
    command->run();
  });
  board->footer("Example: naocal board -o boards.pdf --boards boards.json; print it and measure the rulers, then\n"
                "  naocal board --boards boards.json --measured 0.1995,0.1990");
}

} // namespace naocal
