#include "report/AliasesData.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

using nlohmann::json;

namespace {

constexpr Range share{0, 1, ""};

/// Similarity matrix of the first candidates.
struct Aliases {
  std::vector<std::string> candidates;
  std::vector<std::vector<double>> alike;

  /// The most similar pair, of all candidates or of those with one given candidate.
  std::pair<std::size_t, std::size_t> closest(std::optional<std::size_t> with = {}) const {
    std::pair<std::size_t, std::size_t> best{0, 1};
    double most = -1;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      for (std::size_t j = 0; j < candidates.size(); ++j) {
        if ((with ? i == *with && j != i : i < j) && alike[i][j] > most) {
          most = alike[i][j];
          best = {i, j};
        }
      }
    }
    return best;
  }
};

/// The confusable pair that needs the most additional data.
std::string confusedSentence(const std::vector<JsonCursor>& confusable) {
  const auto times = [](const JsonCursor& pair) { return pair.at("timesTheData").number(anyNumber); };
  const JsonCursor& hardest =
      *std::max_element(confusable.begin(), confusable.end(),
                        [&](const JsonCursor& a, const JsonCursor& b) { return times(a) < times(b); });
  return fmt::format("These captures cannot tell {} from {} (correlation {:.4g}{}): {}.", hardest.at("taken").text(),
                     hardest.at("other").text(), hardest.at("correlation").number(share),
                     confusable.size() > 1 ? fmt::format("; the hardest of {} such pairs", confusable.size()) : "",
                     times(hardest) > 1
                         ? fmt::format("they would need {:.2g} times as much data of this kind, or poses "
                                       "in which the two differ more",
                                       times(hardest))
                         : "both happen to explain them almost as well; further captures will tell");
}

/// Summary of the matrix. `taken`: labels added to the model.
std::string aliasSentence(const Aliases& aliases, const std::vector<JsonCursor>& confusable,
                          const std::vector<std::string>& taken) {
  if (!confusable.empty()) {
    return confusedSentence(confusable);
  }
  if (aliases.candidates.size() < 2) {
    return {};
  }
  for (std::size_t i = 0; i < aliases.candidates.size(); ++i) {
    if (std::find(taken.begin(), taken.end(), aliases.candidates[i]) != taken.end()) {
      const std::size_t other = aliases.closest(i).second;
      return fmt::format("These captures tell {} from all others here; most alike is {} (correlation {:.4g}).",
                         aliases.candidates[i], aliases.candidates[other], aliases.alike[i][other]);
    }
  }
  const auto [one, other] = aliases.closest();
  const double most = aliases.alike[one][other];
  return fmt::format(
      "Most alike are {} and {} (correlation {:.4g}): were one of them there, these poses would {} which.",
      aliases.candidates[one], aliases.candidates[other], most, most > 0.9 ? "hardly tell" : "tell");
}

} // namespace

json aliasesData(const JsonCursor& diagnosis) {
  const auto matrix = diagnosis.find("aliases");
  if (!matrix) {
    return nullptr;
  }
  const std::vector<std::string> candidates = matrix->at("candidates").texts();
  Aliases aliases{candidates, {}};
  for (const JsonCursor& row : matrix->at("correlations").elements()) {
    aliases.alike.push_back(row.numbers(candidates.size(), share, "one per candidate"));
  }
  if (aliases.alike.size() != candidates.size()) {
    matrix->at("correlations").refuse("one row per candidate");
  }
  const std::vector<JsonCursor> confusable = matrix->at("confusable").elements();
  json pairs = json::array();
  for (const JsonCursor& pair : confusable) {
    pairs.push_back({pair.at("taken").text(), pair.at("other").text()});
  }
  return {{"candidates", candidates},
          {"correlations", aliases.alike},
          {"confusable", pairs},
          {"sentence", aliasSentence(aliases, confusable, diagnosis.at("suggested").texts())}};
}

} // namespace naocal
