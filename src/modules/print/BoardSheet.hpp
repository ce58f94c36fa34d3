#pragma once

#include "data/Board.hpp"
#include "print/Paper.hpp"
#include "print/PdfDocument.hpp"

#include <cstddef>

namespace naocal {

/// Lengths that the two rulers beside a printed pattern are meant to have [m].
struct PrintedRulers {
  double alongRows = 0, alongColumns = 0;
};

/// Rulers of a pattern: 0.2 m each, or the longest of 0.15, 0.1, 0.05, 0.02 and 0.01 m that fits beside it.
PrintedRulers printedRulers(const CharucoPattern& pattern);

/// The pattern with the largest squares, in whole millimetres, that fit on the paper, and markers of three quarters of
/// that. Throws InputError if squares would be smaller than 5 mm.
CharucoPattern fitToPaper(CharucoPattern pattern, const Paper& paper);

/// Adds a page with a ChArUco board in true size: pattern, rulers, instructions, cut marks, id, dictionary and marker
/// ids. Throws InputError if the paper is too small.
void addBoardSheet(PdfDocument& pdf, const Board& board, const Paper& paper);

/// Adds the board spread over several sheets, joined in the middle of squares, far from corners; each has a strip to
/// glue the next ones onto. Returns the number of sheets. Throws InputError if a square does not fit on a sheet.
std::size_t addBoardTiles(PdfDocument& pdf, const Board& board, const Paper& paper);

} // namespace naocal
