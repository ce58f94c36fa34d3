#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace naocal {

/// Bad input from outside (a file, an option): one sentence that says where, what was expected and what was found.
/// Caught in `main`, which prints it and ends with exit code 2.
class InputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Of the known names those that differ from `text` in the fewest letters, best first, for people who mistyped.
std::vector<std::string> closestNames(const std::string& text, const std::vector<std::string>& known,
                                      std::size_t most = 5);

} // namespace naocal
