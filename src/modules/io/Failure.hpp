#pragma once

#include <exception>
#include <string>

namespace naocal {

/// The end of a program after an exception: 2 for wrong input and for what the system refuses, 1 for an internal error.
struct Failure {
  int exitCode;
  std::string sentence;
};

/// The sentence for an exception in `main`, without a library's words: of InputError its own, for a file that the
/// system refuses its name and the reason, for exhausted memory and for numbers beyond the range of a function what to
/// do.
Failure describeFailure(const std::exception& error);

/// Makes a process that cannot handle an exception end with "<program>: <sentence>" and the exit code, not by a signal:
/// destructors of the JSON library allocate, and where memory is exhausted they cannot throw. `program` must outlive
/// the process.
void endWithSentence(const char* program);

} // namespace naocal
