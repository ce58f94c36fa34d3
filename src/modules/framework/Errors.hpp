#pragma once

#include <stdexcept>

namespace naocal {

/// Modules that do not fit together, found before the first cycle: one sentence with the names of all concerned.
class WiringError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A configuration that cannot be used: one sentence that says where, what was expected and what was found.
class ConfigurationError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

} // namespace naocal
