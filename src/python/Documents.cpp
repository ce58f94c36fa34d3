#include "python/Documents.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

namespace py = pybind11;

py::object parseDocument(const std::string& json) {
  return py::module_::import("json").attr("loads")(py::str(json));
}

py::object toDictionary(const nlohmann::json& json) {
  return parseDocument(json.dump());
}

} // namespace naocal
