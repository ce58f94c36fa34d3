#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

class AnyProduction;
class Configuration;
class Thread;

/// Modules that do not fit together, found before the first cycle: one sentence with the names of all concerned.
class WiringError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// All productions of all threads by their keys. Making it connects every dependency with its production and sorts each
/// thread's modules so that a value is computed before it is used; modules that need nothing of each other keep the
/// order in which they were added.
class Database {
public:
  /// Throws WiringError: a dependency that nobody produces or of another type, a production of two modules, modules
  /// that depend on each other in a circle, a dependency on another thread that is neither a History nor a Latest, a
  /// Latest with two readers.
  explicit Database(const std::vector<Thread*>& threads);

  /// The production of a key such as "Motion.JointAngles"; nullptr: none.
  AnyProduction* find(std::string_view key) const;

private:
  std::map<std::string, AnyProduction*, std::less<>> productions_;
};

/// Mounts `<module>.json` as `<thread>.<module>` for every module of a thread that has parameters, gives each parameter
/// its value, and has later changes reach the module between its cycles. Returns a sentence for each key of a file that
/// no parameter has. Throws ConfigurationError that names thread, module, key and file for a missing key or a wrong
/// type.
std::vector<std::string> configureModules(Thread& thread, Configuration& configuration);

} // namespace naocal
