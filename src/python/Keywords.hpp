#pragma once

#include "io/InputError.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <utility>

namespace naocal {

/// The keyword arguments of a Python call. Absent ones and None leave the default.
class Keywords {
public:
  explicit Keywords(pybind11::kwargs given) : given_{std::move(given)} {}

  /// Whether the argument is given and not None.
  bool has(const char* name) const { return given_.contains(name) && !pybind11::object{given_[name]}.is_none(); }

  /// Throws TypeError for another type.
  template <class T> void take(const char* name, T& value) const {
    if (!has(name)) {
      return;
    }
    try {
      value = given_[name].template cast<T>();
    } catch (const pybind11::cast_error&) {
      const pybind11::object found = given_[name];
      throw pybind11::type_error{
          fmt::format("{}: expected {}, found {}", name, describe<T>(), pybind11::repr(found).cast<std::string>())};
    }
  }

  /// Throws InputError beyond the range, too.
  template <class Number> void take(const char* name, Number& value, Number lowest, Number highest) const {
    take(name, value);
    if (!(value >= lowest && value <= highest)) {
      throw InputError{fmt::format("{}: expected {} to {}, found {}", name, lowest, highest, value)};
    }
  }

  pybind11::object object(const char* name) const {
    return has(name) ? pybind11::object{given_[name]} : pybind11::none();
  }

private:
  template <class T> static std::string describe() {
    if constexpr (std::is_same_v<T, bool>) {
      return "True or False";
    } else if constexpr (std::is_integral_v<T>) {
      return "a whole number";
    } else if constexpr (std::is_floating_point_v<T>) {
      return "a number";
    } else if constexpr (std::is_same_v<T, std::string>) {
      return "a text";
    } else if constexpr (std::is_same_v<T, std::filesystem::path>) {
      return "a path";
    } else {
      return "a list of texts";
    }
  }

  pybind11::kwargs given_;
};

} // namespace naocal
