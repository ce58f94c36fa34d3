#include "start/PrintableBoards.hpp"

#include "print/BoardSheet.hpp"

namespace naocal {

std::string printableBoards(std::string_view paper) {
  const Paper& sheet = findPaper(paper);
  CharucoPattern pattern = fitToPaper({}, sheet);
  PdfDocument pdf{"naocal board", "ChArUco boards for naocal"};
  for (const char* const id : {"A", "B", "C", "D"}) {
    Board board;
    board.id = id;
    board.pattern = pattern;
    board.points = innerCorners(pattern);
    addBoardSheet(pdf, board, sheet);
    pattern.firstMarkerId += markerCount(pattern);
  }
  return pdf.finish();
}

} // namespace naocal
