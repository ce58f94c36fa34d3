#pragma once

#include "dialects/Dialect.hpp"

#include <span>

namespace naocal {

/// All dialects, and one by its name; throws InputError that lists the names.
std::span<const Dialect> dialects();
const Dialect& findDialect(const std::string& name);

/// Names of all dialects.
std::vector<std::string> dialectNames();

/// What of a calibration a dialect's files have no place for, as words: "the shift of camera top".
std::vector<std::string> unwritten(const Dialect& dialect, const RobotCalibration& calibration, const Robot& robot);

} // namespace naocal
