#pragma once

#include "fuzz/driver/Reader.hpp"

#include <optional>

namespace naocal {

inline constexpr int longestWait = 60;     // [s] of wall time: a reader that sleeps
inline constexpr long largestGrowth = 512; // [MiB] of the process's peak of resident memory

/// Reads one input. Returns what is wrong with the reader, in a sentence; absent if it accepts or refuses the input as
/// documented, in at most `growth` [MiB]. Aborts the process, with a sentence on standard error, if it takes longer
/// than `Reader::longest` or `longestWait`. Sets SIGPROF and a thread-less timer; not for two threads.
std::optional<std::string> findFault(const Reader& reader, std::string_view bytes, long growth = largestGrowth);

} // namespace naocal
