#include "Rung.hpp"

#include "estimation/ModelBuilder.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

std::vector<std::string> without(const std::vector<std::string>& labels, const std::vector<std::string>& others) {
  std::vector<std::string> rest;
  std::copy_if(labels.begin(), labels.end(), std::back_inserter(rest),
               [&](const std::string& label) { return !contains(others, label); });
  return rest;
}

} // namespace

bool contains(const std::vector<std::string>& labels, const std::string& label) {
  return std::find(labels.begin(), labels.end(), label) != labels.end();
}

std::vector<std::string> labelsOf(const Model& model) {
  std::vector<std::string> labels;
  for (const Term& term : model.terms()) {
    if (!term.isPlacement && term.asked) {
      labels.push_back(term.label());
    }
  }
  return labels;
}

Rung firstRung(const OpenedSets& opened, const Measurements& measurements) {
  if (opened.terms.empty()) {
    return {.with = opened.with, .without = opened.without, .definitions = opened.definitions};
  }
  const std::vector<std::string> base = labelsOf(makeModel(measurements));
  std::vector<std::string> with = without(opened.terms, base);
  // the base has every offset that can be asked for; others are along because torques depend on them
  std::erase_if(with, [](const std::string& label) { return label.starts_with("jointOffset@"); });
  return {.with = std::move(with), .without = without(base, opened.terms), .definitions = opened.definitions};
}

nlohmann::json rungForPanel(const Rung& rung) {
  nlohmann::json json{{"with", rung.with}, {"without", rung.without}, {"step", rung.step}, {"rms", rung.rmsPx}};
  if (rung.questioned) {
    if (rung.questioned->heldOutPx) {
      json["heldOut"] = *rung.questioned->heldOutPx;
    }
    json["floor"] = rung.questioned->noiseFloorPx;
    json["alarm"] = rung.questioned->alarm;
  }
  return json;
}

} // namespace naocal
