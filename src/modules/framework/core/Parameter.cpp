#include "framework/core/Parameter.hpp"

#include "framework/configuration/ConfigurationLayers.hpp"
#include "protocol/BoundedJson.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

std::string shortened(const nlohmann::json& value) {
  const std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  return text.size() <= 60 ? text : text.substr(0, 60) + "...";
}

} // namespace

AnyParameter::AnyParameter(Module& owner, std::string key) : key_{std::move(key)} {
  owner.parameters_.push_back(this);
}

void refuseValue(const nlohmann::json& value, const std::string& expected) {
  throw ConfigurationError{fmt::format("expected {}, found {}", expected, shortened(value))};
}

void refuseValue(const nlohmann::json& value) {
  try {
    throw;
  } catch (const std::exception& error) {
    throw ConfigurationError{
        fmt::format("expected another value than {}: {}", shortened(value), parseErrorReason(error))};
  }
}

void requireBoolean(const nlohmann::json& value) {
  if (!value.is_boolean()) {
    refuseValue(value, "true or false");
  }
}

void requireNumber(const nlohmann::json& value) {
  if (!value.is_number()) {
    refuseValue(value, "a number");
  }
}

void requireInteger(const nlohmann::json& value, double lowest, double highest) {
  if (!value.is_number_integer() || value.get<double>() < lowest || value.get<double>() > highest) {
    refuseValue(value, fmt::format("a whole number from {:.0f} to {:.0f}", lowest, highest));
  }
}

} // namespace naocal
