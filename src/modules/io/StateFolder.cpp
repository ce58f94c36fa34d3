#include "io/StateFolder.hpp"

#include "io/InputError.hpp"

#include <cstdlib>

namespace naocal {
namespace {

std::filesystem::path absolutePath(const char* variable) {
  const char* given = std::getenv(variable);
  const std::filesystem::path path = given == nullptr ? "" : given;
  return path.is_absolute() ? path : "";
}

} // namespace

std::filesystem::path stateFolder() {
  if (const auto state = absolutePath("XDG_STATE_HOME"); !state.empty()) {
    return state / "naocal";
  }
  if (const auto home = absolutePath("HOME"); !home.empty()) {
    return home / ".local" / "state" / "naocal";
  }
  throw InputError{
      "--state: expected a folder for what the robot learns, as neither XDG_STATE_HOME nor HOME says where "
      "one would be, found none"};
}

} // namespace naocal
