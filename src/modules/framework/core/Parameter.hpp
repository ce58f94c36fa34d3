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
#include <vector>

namespace naocal {

/// What wiring and configuration see of a parameter: a key of its module's file.
class AnyParameter {
public:
  AnyParameter(Module& owner, std::string key);
  virtual ~AnyParameter() = default;
  AnyParameter(const AnyParameter&) = delete;
  AnyParameter& operator=(const AnyParameter&) = delete;

  const std::string& key() const { return key_; }

  /// A command for this moment, such as "start": saving leaves it out, so that no file holds yesterday's command.
  virtual bool isCommand() const { return false; }

  /// Reads a value on any thread and returns what puts it into effect on the module's own thread. Throws
  /// ConfigurationError that says what was expected and found, without the place.
  virtual std::function<void()> prepare(const nlohmann::json& value) = 0;

private:
  std::string key_;
};

/// Throw ConfigurationError unless the value is what they ask for; `refuseValue` turns the exception of a `from_json`
/// that is being handled into one.
void requireBoolean(const nlohmann::json& value);
void requireNumber(const nlohmann::json& value);
void requireInteger(const nlohmann::json& value, double lowest, double highest);
[[noreturn]] void refuseValue(const nlohmann::json& value);
[[noreturn]] void refuseValue(const nlohmann::json& value, const std::string& expected);

/// A number, text, list or structure (with `from_json`) that a person configures; changes take effect between cycles.
template <class T> class Parameter : public AnyParameter {
public:
  /// What is wrong with a value ("expected a positive number"), empty when nothing is: `expected` in the refusal.
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
      value_ = std::move(read);
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

/// A command rather than a setting: that it was given counts, not only its value.
template <class T> class CommandParameter final : public Parameter<T> {
public:
  using Parameter<T>::Parameter;
  bool isCommand() const override { return true; }

  /// Whether it was given anew since the last call. What the file says was not given.
  bool takeCommand() {
    const bool given = seen_ > 0 && this->writes() != seen_;
    seen_ = this->writes();
    return given;
  }

private:
  std::uint64_t seen_ = 0;
};

// What numbers may be asked to be (Parameter::Check): each says what it expects of a value that is not so.

/// A number from Low to High.
template <int Low, int High, class T> std::string checkWithin(const T& value) {
  const bool is = value >= Low && value <= High; // not so for what is no number
  return is ? "" : "a number from " + std::to_string(Low) + " to " + std::to_string(High);
}

/// Some numbers from Low to High, at most twenty.
template <int Low, int High> std::string checkEachWithin(const std::vector<double>& values) {
  const bool are =
      !values.empty() && values.size() <= 20 &&
      std::all_of(values.begin(), values.end(), [](double value) { return value >= Low && value <= High; });
  return are ? "" : "a list of one to twenty numbers from " + std::to_string(Low) + " to " + std::to_string(High);
}

/// Above none, at most the whole.
inline std::string checkShare(const double& value) {
  return value > 0 && value <= 1 ? "" : "a number above 0, at most 1";
}

} // namespace naocal
