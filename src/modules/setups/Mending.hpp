#pragma once

#include "setups/SetUp.hpp"

#include <string>
#include <vector>

namespace naocal {

/// Whether a label changes the captures instead of the model: a mistake of the set-up (`allSetUps`), such as
/// "reversedJoint@elbow", or what is left out (`isLeftOut`).
bool isSetUp(const std::string& label);

/// Labels from a list that was split at its commas: "countedFrom@elbow,shoulder" is one. A piece that has no '@' and is
/// no label of its own belongs to the one before it.
std::vector<std::string> joinLabels(const std::vector<std::string>& pieces);

/// Takes the labels of wrong set-ups out of `with` and undoes these mistakes in the sets and the robot. Where one may
/// have been made in several ways, the one counts that fits best. First of all leaves out what is to be. Returns all
/// these labels. Throws InputError for what these sets cannot have.
std::vector<std::string> mendSetUps(std::vector<std::string>& with, Robot& robot, std::vector<CaptureSet>& sets);

} // namespace naocal
