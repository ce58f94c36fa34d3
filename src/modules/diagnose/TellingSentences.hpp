#pragma once

#include "diagnose/TellingPairs.hpp"

#include <string>

namespace naocal {

/// "the torque on LHipPitch", "the direction from which LHipPitch was approached"
std::string drivenBy(const DriverValues& driver, const Robot& robot);

/// "errors down over the torque on LHipPitch"
std::string tellingLabel(const TellingPair& pair, const std::vector<DriverValues>& drivers, const Robot& robot);

/// What the plot shows: "Errors down of ±6.0 px change sign with the direction from which LHipPitch was approached: 87
/// % of the squared error."
std::string tellingSentence(const TellingPair& pair, const std::vector<DriverValues>& drivers, const Robot& robot);

/// Of the most telling one, or that there is none.
std::string tellingSentence(const TellingPairs& telling, const std::vector<DriverValues>& drivers, const Robot& robot);

} // namespace naocal
