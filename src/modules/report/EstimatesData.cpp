#include "report/EstimatesData.hpp"

#include "io/Units.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

namespace naocal {

using nlohmann::json;

namespace {

/// "joint offset" for jointOffset.
std::string spaced(const std::string& name) {
  std::string words;
  for (const char letter : name) {
    if (std::isupper(static_cast<unsigned char>(letter))) {
      words += ' ';
    }
    words += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return words;
}

/// The answer over what could be missing, where that was asked; else that of the model as it is, which is `fitted`.
json estimateJson(const std::string& name, const JsonPlace& unknown, double scale) {
  const auto averaged = unknown.find("averaged");
  const JsonPlace& answer = averaged ? *averaged : unknown;
  const std::vector<double> ends =
      answer.at(averaged ? "interval" : "interval95").numbers(2, {-1e15, 1e15, ""}, "lower and upper end");
  return {{"name", name},
          {"value", scale * answer.at("value").number({-1e15, 1e15, ""})},
          {"sigma", scale * answer.at("sigma").number({0, 1e15, ""})},
          {"fitted", scale * unknown.at("value").number({-1e15, 1e15, ""})},
          {"low", scale * ends[0]},
          {"high", scale * ends[1]},
          {"learned", unknown.at("learned").number({-1e15, 1, ""})}};
}

} // namespace

json estimatesData(const JsonPlace& effects) {
  json groups = json::array();
  for (const JsonPlace& effect : effects.elements()) {
    const std::string title = spaced(effect.at("effect").text()), at = effect.at("at").text();
    const auto unknowns = effect.at("unknowns").members();
    for (const auto& [name, unknown] : unknowns) {
      const auto [unit, scale] = shownUnit(unknown.at("unit").text());
      auto group = std::find_if(groups.begin(), groups.end(),
                                [&, &u = unit](const json& g) { return g["title"] == title && g["unit"] == u; });
      if (group == groups.end()) {
        const json empty{{"title", title}, {"unit", unit}, {"rows", json::array()}};
        group = groups.insert(groups.end(), empty);
      }
      (*group)["rows"].push_back(estimateJson(unknowns.size() == 1 ? at : at + " " + name, unknown, scale));
    }
  }
  return groups;
}

} // namespace naocal
