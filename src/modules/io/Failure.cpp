#include "io/Failure.hpp"

#include "io/InputError.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <new>
#include <stdexcept>

namespace naocal {

Failure describeFailure(const std::exception& error) {
  if (dynamic_cast<const InputError*>(&error) != nullptr) {
    return {2, error.what()};
  }
  if (const auto* refused = dynamic_cast<const std::filesystem::filesystem_error*>(&error)) {
    return {2, fmt::format("{}: the system refuses it: {}; choose another place or change its permissions",
                           refused->path1().string(), refused->code().message())};
  }
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    return {2, "the memory is exhausted; end other programs, or use fewer captures or smaller pictures"};
  }
  const std::string_view said = error.what();
  if (dynamic_cast<const std::domain_error*>(&error) != nullptr || said.find("boost::math") != said.npos) {
    return {2, "the numbers leave the range that can be computed; look for huge values in the captures, and in the "
               "corrections of effects that were given"};
  }
  return {1, fmt::format("internal error: {}", said)};
}

} // namespace naocal
