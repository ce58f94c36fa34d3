#pragma once

#include <cstring>
#include <fmt/format.h>
#include <stdexcept>

namespace naocal {

/// Why a camera does not deliver, as the end of a sentence. Stays within the driver.
class VideoError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Throws for the negative result of a system call; else hands it on.
inline int checked(int result, const char* what) {
  if (result < 0) {
    throw VideoError{fmt::format("{}: {}", what, std::strerror(-result))};
  }
  return result;
}

} // namespace naocal
