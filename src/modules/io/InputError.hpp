#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace naocal {

/// Invalid external input (a file, an option): one sentence with location, expected and found. Caught in `main`, which
/// prints it and exits with code 2.
class InputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Known names with the smallest edit distance to `text`, best first, as suggestions for misspelt names.
std::vector<std::string> closestNames(const std::string& text, const std::vector<std::string>& known,
                                      std::size_t most = 5);

} // namespace naocal
