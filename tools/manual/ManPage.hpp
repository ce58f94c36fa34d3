#pragma once

#include "CommandText.hpp"

#include <string>

namespace naocal::manual {

/// The manual page of a program or a command, in the man macros of troff; `program` is the program that it belongs to.
std::string manPage(const Command& command, const Command& program, const std::string& version);

/// "naocal-solve" of "naocal solve".
std::string pageName(const std::string& words);

} // namespace naocal::manual
