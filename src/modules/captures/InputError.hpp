#pragma once

#include <stdexcept>

namespace naocal {

/// Bad input from outside (a file, an option): one sentence that says where, what was expected and what was found.
/// Caught in `main`, which prints it and ends with exit code 2.
class InputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

} // namespace naocal
