#include "Commands.hpp"
#include "Sets.hpp"

#include "calibrate/Comparison.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

struct CompareCommand {
  std::string result, json;
  std::vector<std::string> sets;
  bool samePlace = false, skipBad = false;
};

void compareSets(const CompareCommand& command) {
  const StoredResult result = readResult(command.result);
  const GivenSets given = readSets(command.sets, command.skipBad);
  const Comparison comparison = compare(result, given.sets, given.robot, command.samePlace);
  if (!command.json.empty()) {
    writeJson(comparisonJson(comparison), command.json);
  }
  if (command.json == "-") {
    return;
  }
  fmt::print("{} corners that the result has not seen: {:.2f} px rms from their predictions (median {:.2f}); with the "
             "drawing alone {:.2f} px\n\n",
             comparison.all.corners, comparison.all.rmsPx, comparison.all.medianPx, comparison.nominal.rmsPx);
  for (const auto& [title, groups] :
       {std::pair{"board", &comparison.byBoard}, std::pair{"camera", &comparison.byCamera}}) {
    for (const auto& [name, distances] : *groups) {
      fmt::print("  {:<7} {:<12} {:>7.2f} px rms {:>7.2f} px median {:>7} corners\n", title, name, distances.rmsPx,
                 distances.medianPx, distances.corners);
    }
  }
  if (!comparison.ignored.empty()) {
    fmt::print("\nnot touched by these captures: {}\n", fmt::join(comparison.ignored, ", "));
  }
}

} // namespace

void addCompare(CLI::App& app) {
  auto command = std::make_shared<CompareCommand>();
  CLI::App* comparer = app.add_subcommand("compare", "predicts captures that a result has not seen");
  comparer->footer("Example: naocal compare result.json other-captures/");
  comparer->add_option("RESULT", command->result, "a result file of 'naocal solve'")->required();
  comparer->add_option("SET", command->sets, "folders with captures.json")->required();
  comparer->add_option("--json", command->json, "write JSON to a file, or - for standard output");
  comparer->add_flag("--same-place", command->samePlace, "boards and feet are where the result found them");
  comparer->add_flag("--skip-bad", command->skipBad, "use the other captures when some cannot be used, and list those");
  comparer->callback([command] { compareSets(*command); });
}

} // namespace naocal
