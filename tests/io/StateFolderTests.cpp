#include "io/StateFolder.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <optional>
#include <string>

namespace naocal {
namespace {

/// RAII environment variable: set, or unset for nullptr, and restored at the end.
class Variable {
public:
  Variable(const char* name, const char* value) : name_{name} {
    if (const char* before = std::getenv(name)) {
      before_ = before;
    }
    value != nullptr ? ::setenv(name, value, 1) : ::unsetenv(name);
  }
  ~Variable() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }

private:
  const char* name_;
  std::optional<std::string> before_;
};

} // namespace

TEST_CASE("what robots learn is kept where the XDG specification says, unless told otherwise") {
  // Pins the folder with and without each variable; relative paths are ignored.
  const Variable home{"HOME", "/home/ada"};
  for (const char* useless : {static_cast<const char*>(nullptr), "", "relative"}) {
    const Variable state{"XDG_STATE_HOME", useless};
    CHECK(stateFolder() == "/home/ada/.local/state/naocal");
    const Variable noHome{"HOME", nullptr};
    CHECK_THROWS_WITH(stateFolder(), Catch::Contains("--state: expected a folder"));
  }
  const Variable state{"XDG_STATE_HOME", "/var/state"};
  CHECK(stateFolder() == "/var/state/naocal");
}

} // namespace naocal
