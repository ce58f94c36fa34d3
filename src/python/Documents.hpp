#pragma once

#include <nlohmann/json_fwd.hpp>
#include <pybind11/pybind11.h>
#include <string>

namespace naocal {

/// The dictionary that Python's `json` reads from this text.
pybind11::object parseDocument(const std::string& json);

/// The dictionary that Python's `json` reads from the file with this JSON.
pybind11::object toDictionary(const nlohmann::json& json);

} // namespace naocal
