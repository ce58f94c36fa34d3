#pragma once

#include "calibration/result/Finding.hpp"

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace naocal {

/// Prints the first finding's sentence, then the others with their levels; of mere notes the first few.
void printFindings(const std::vector<Finding>& findings);

/// Adds --fail-on: the least serious level, "stop" or "act", of a finding that ends a command with exit code 3.
void addFailOn(CLI::App& command, std::string& level);

/// Whether there is a finding of this level ("stop", "act") or a more serious one.
bool isAnyAsSerious(const std::vector<Finding>& findings, const std::string& level);

} // namespace naocal
