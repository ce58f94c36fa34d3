#pragma once

#include "OpenedSets.hpp"

#include "diagnosis/Session.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// Where to begin: the base model, or that of the result that was opened.
Rung firstRung(const OpenedSets& opened, const Measurements& measurements);

/// For the panel's ladder.
nlohmann::json rungForPanel(const Rung& rung);

/// The labels of a model's effects that were asked for.
std::vector<std::string> labelsOf(const Model& model);

bool contains(const std::vector<std::string>& labels, const std::string& label);

} // namespace naocal
