#pragma once

#include "OpenedSets.hpp"

#include "diagnose/Diagnosis.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A model that was tried: the base with and without some effects, and how well it did.
struct Rung {
  std::vector<std::string> with, without; // "E@P"
  std::string definitions = "[]";         // the person's own effects: a list of JSON
  std::string step;                       // "+ elasticity@LKneePitch"; empty for the first
  double rmsPx = 0;
  std::optional<Step> questioned; // once it was put to the question
};

/// Where to begin: the base model, or that of the result that was opened.
Rung firstRung(const OpenedSets& opened, const Measurements& measurements);

/// For the panel's ladder.
nlohmann::json rungJson(const Rung& rung);

/// The labels of a model's effects that were asked for.
std::vector<std::string> labelsOf(const Model& model);

bool contains(const std::vector<std::string>& labels, const std::string& label);

} // namespace naocal
