#pragma once

#include "calibration/ReadingErrors.hpp"
#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A text that may be empty.
std::string label(const JsonCursor& place);

/// Index of an entry in a list of the page.
std::size_t indexIn(const nlohmann::json& list, const JsonCursor& place);

/// Elements of a list that may be absent.
std::vector<JsonCursor> elementsOf(const JsonCursor& object, const std::string& key);

/// Rounds to a number of decimals.
double roundToDecimals(double value, int decimals);

/// Unit of the keys `*Px` of a result or a diagnosis, as pages show them.
ErrorUnit shownErrorUnit(const JsonCursor& document);

/// Unit of a driver that a diagnosis has recorded, by its name in expressions: of a joint "rad", or "m" if it slides.
std::optional<std::string> recordedUnit(const JsonCursor& diagnosis, const std::string& driver);

/// "0.53 px"; three decimals below 1 of any other unit. `fileError`: the number in the file.
std::string formatError(double fileError, const ErrorUnit& errors);

} // namespace naocal
