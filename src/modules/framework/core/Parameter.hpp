#pragma once

#include "framework/core/Module.hpp"

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace naocal {

/// Type-erased parameter, as wiring and configuration use it: a key of the module's file.
class AnyParameter {
public:
  AnyParameter(Module& owner, std::string key);
  virtual ~AnyParameter() = default;
  AnyParameter(const AnyParameter&) = delete;
  AnyParameter& operator=(const AnyParameter&) = delete;

  const std::string& key() const { return key_; }

  /// A momentary command such as "start"; never saved.
  virtual bool isCommand() const { return false; }

  /// Parses a value on any thread; the returned function applies it and runs on the module's thread. Throws
  /// ConfigurationError that says what was expected and found, without the place.
  virtual std::function<void()> prepare(const nlohmann::json& value) = 0;

private:
  std::string key_;
};

/// Checks that throw ConfigurationError. `refuseValue(value)` must be called in a handler: it converts the exception of
/// a `from_json` into ConfigurationError.
void requireBoolean(const nlohmann::json& value);
void requireNumber(const nlohmann::json& value);
void requireInteger(const nlohmann::json& value, double lowest, double highest);
[[noreturn]] void refuseValue(const nlohmann::json& value);
[[noreturn]] void refuseValue(const nlohmann::json& value, const std::string& expected);

/// A configurable number, text, list or structure (with `from_json`); changes take effect between cycles.
template <class T> class Parameter : public AnyParameter {
public:
  /// Validates a value: returns the expectation ("a positive number"), used in the error message; empty if valid.
  using Check = std::string (*)(const T&);

  Parameter(Module& owner, std::string key, Check check = nullptr)
      : AnyParameter{owner, std::move(key)}, check_{check} {}

  const T& operator*() const { return value_; }
  const T* operator->() const { return &value_; }

  std::function<void()> prepare(const nlohmann::json& value) override {
    T read = converted(value);
    if (const std::string expected = check_ ? check_(read) : std::string{}; !expected.empty()) {
      refuseValue(value, expected);
    }
    return [this, read = std::move(read)]() mutable {
      std::swap(value_, read); // the former value is freed with this function
      ++writes_;
    };
  }

protected:
  std::uint64_t writes() const { return writes_; }

private:
  template <class Json> static T converted(const Json& value) {
    if constexpr (std::is_same_v<T, bool>) {
      requireBoolean(value);
    } else if constexpr (std::integral<T>) {
      requireInteger(value, double(std::numeric_limits<T>::lowest()), double(std::numeric_limits<T>::max()));
    } else if constexpr (std::floating_point<T>) {
      requireNumber(value);
    }
    try {
      return value.template get<T>();
    } catch (const std::exception&) {
      refuseValue(value);
    }
  }

  Check check_;
  T value_{};
  std::uint64_t writes_ = 0;
};

/// A parameter that acts as a command: setting it counts even if the value stays the same.
template <class T> class CommandParameter final : public Parameter<T> {
public:
  using Parameter<T>::Parameter;
  bool isCommand() const override { return true; }

  /// Whether it was set since the last call. The initial value from the file does not count.
  bool takeCommand() {
    const bool given = seen_ > 0 && this->writes() != seen_;
    seen_ = this->writes();
    return given;
  }

private:
  std::uint64_t seen_ = 0;
};

// Validators (Parameter::Check): each returns its expectation, empty if the value is valid.

/// A number from Low to High.
template <int Low, int High, class T> std::string checkWithin(const T& value) {
  const bool is = value >= Low && value <= High; // false for NaN
  return is ? "" : "a number from " + std::to_string(Low) + " to " + std::to_string(High);
}

/// A list of one to twenty numbers from Low to High.
template <int Low, int High> std::string checkEachWithin(const std::vector<double>& values) {
  const bool are =
      !values.empty() && values.size() <= 20 &&
      std::all_of(values.begin(), values.end(), [](double value) { return value >= Low && value <= High; });
  return are ? "" : "a list of one to twenty numbers from " + std::to_string(Low) + " to " + std::to_string(High);
}

/// A fraction in (0, 1].
inline std::string checkShare(const double& value) {
  return value > 0 && value <= 1 ? "" : "a number above 0, at most 1";
}

} // namespace naocal
