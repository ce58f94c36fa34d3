#include "RobotPlace.hpp"

#include "io/InputError.hpp"

#include <charconv>
#include <fmt/format.h>

namespace naocal {

RobotPlace robotPlace(const std::string& address) {
  constexpr std::uint16_t usual = 12440;
  if (address.starts_with('/')) {
    return {"", 0, address};
  }
  const std::size_t colon = address.find(':');
  RobotPlace place{address.substr(0, colon), usual, ""};
  bool good = !place.host.empty() && place.host.find_first_of(" \t\r\n/@") == std::string::npos;
  if (colon != std::string::npos) {
    const char *const first = address.data() + colon + 1, *const last = address.data() + address.size();
    const auto [end, error] = std::from_chars(first, last, place.basePort);
    good = good && error == std::errc{} && end == last && place.basePort >= 1 && place.basePort <= 65533;
  }
  if (!good) {
    throw InputError{fmt::format("expected a robot's name or IPv4 address, HOST:PORT with its base port, or the folder "
                                 "of its UNIX sockets beginning with /; found \"{}\"",
                                 address)};
  }
  return place;
}

} // namespace naocal
