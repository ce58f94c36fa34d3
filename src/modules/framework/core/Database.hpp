#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

class AnyProduction;
class Thread;

/// Modules that cannot be connected, detected before the first cycle; the message names all modules concerned.
class WiringError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// All productions of all threads by key. The constructor connects every dependency with its production and sorts each
/// thread's modules topologically; independent modules keep the order in which they were added.
class Database {
public:
  /// Throws WiringError for: a dependency without a production, or of another type; a production of two modules;
  /// circular dependencies; a dependency on another thread that is neither a History nor a Latest; a Latest with two
  /// readers.
  explicit Database(const std::vector<Thread*>& threads);

  /// The production of a key such as "Motion.JointAngles"; nullptr if there is none.
  AnyProduction* find(std::string_view key) const;

private:
  std::map<std::string, AnyProduction*, std::less<>> productions_;
};

} // namespace naocal
