#pragma once

#include "data/SetReading.hpp"

namespace naocal {

/// Reads `trackers`, `markers`, `frames`, `places`, `distances` and `contactSigma` of a capture set of version 2.
void readInstruments(const JsonCursor& top, SetReading& reading);

/// Reads `points`, `frames` and `contacts` of a capture of version 2.
void readInstrumentReadings(const JsonCursor& place, SetReading& reading, Capture& capture);

/// Their JSON, to be written into a set's and a capture's. `read`: the object that they were read from, or null.
nlohmann::ordered_json instrumentsJson(const Instruments& instruments, const nlohmann::json& read);
nlohmann::ordered_json instrumentReadingsJson(const Capture& capture, const nlohmann::json& read);

} // namespace naocal
