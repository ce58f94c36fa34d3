#include "report/PageValues.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

std::string label(const JsonCursor& place) {
  return place.value().is_string() ? place.value().get<std::string>() : place.text();
}

std::size_t indexIn(const nlohmann::json& list, const JsonCursor& place) {
  return static_cast<std::size_t>(place.integer(0, static_cast<int>(list.size()) - 1));
}

std::vector<JsonCursor> elementsOf(const JsonCursor& object, const std::string& key) {
  const auto list = object.find(key);
  return list ? list->elements() : std::vector<JsonCursor>{};
}

double roundToDecimals(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

ErrorUnit shownErrorUnit(const JsonCursor& document) {
  const auto told = document.find("errorUnit");
  return told ? ErrorUnit{told->at("name").text(), told->at("perPx").number({0, 1e9, ""})} : ErrorUnit{};
}

std::optional<std::string> recordedUnit(const JsonCursor& diagnosis, const std::string& driver) {
  if (const auto recorded = diagnosis.find("recorded")) {
    for (const JsonCursor& one : recorded->elements()) {
      if (one.at("driver").text() == driver) {
        return one.at("unit").text();
      }
    }
  }
  return std::nullopt;
}

std::string formatError(double fileError, const ErrorUnit& errors) {
  const double size = errors.perPx * fileError;
  return fmt::format("{:.{}f} {}", size, errors.name == "px" || size >= 1 ? 2 : 3, errors.name);
}

} // namespace naocal
