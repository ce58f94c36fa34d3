#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace naocal {

/// Where a robot's sockets are: "nao21", "10.1.24.31:12440" (base port; debug is one above, configuration two), or a
/// folder with the UNIX sockets `debug` and `config`.
struct RobotPlace {
  std::string host;             // empty: UNIX sockets
  std::uint16_t basePort = 0;   // [1, 65533]
  std::filesystem::path folder; // of UNIX sockets
};

/// Throws InputError that says what is expected.
RobotPlace robotPlace(const std::string& address);

} // namespace naocal
