#pragma once

#include <string>
#include <string_view>

namespace naocal {

/// PDF of the four default boards, A to D, one page each, with the largest squares that fit on the paper ("a4" to
/// "a0"); what `naocal board --paper PAPER` prints. Throws InputError for other papers.
std::string printableBoards(std::string_view paper);

} // namespace naocal
