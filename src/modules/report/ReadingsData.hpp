#pragma once

#include "io/JsonReader.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace naocal {

/// Name of a tracker's positions or attitudes, or of the contacts, as figures say it. `unit`: "metres" or "radians".
std::string nameReadings(const std::string& instrument, const std::string& unit);

/// Readings that are no corners, for figures: one series per instrument and unit,
///
///   {"title", "unit": "mm", "sigma", "given", "isPlace", "points": [{"of", "target", "place", "at": [x, y, z] [m],
///    "reported": [dx, dy, dz], "fitted": [dx, dy, dz]}]}
///
/// in the world's axes and display units. `sigma`: noise per axis; `of`: the reading's place in `readings`, or in the
/// list of the diagnosis's pictures. `isPlace`: errors are lengths, which can be drawn where they were measured.
nlohmann::json readingsOfResult(const JsonCursor& result);
nlohmann::json readingsOfPictures(const JsonCursor& residuals, std::size_t pictures);

/// Errors of every kind of measurement that a diagnosis has, in its own unit: of the model as given, and with what is
/// suggested; fitted, and held out where the diagnosis was cross-validated. Empty where the ladder of errors says it
/// all.
///
///   [{"title", "unit": "mm", "noise", "rungs": [{"name", "rms", "heldOut"}]}]
///
/// `noise`: what the noise of readings alone would leave, or null; `suggested`: labels of the suggested effects of the
/// catalogue.
nlohmann::json kindErrorsData(const JsonCursor& diagnosis, const nlohmann::json& suggested);

/// Errors of captures that were not used for a fit, per kind of measurement: [{"title", "unit", "count", "rms",
/// "median", "nominal"}], `nominal` with the drawing alone. `comparison`: as 'naocal compare' writes it.
nlohmann::json comparedKindsData(const JsonCursor& comparison);

} // namespace naocal
