#include "commands/Commands.hpp"
#include "console/CommandLine.hpp"
#include "console/OutputFiles.hpp"
#include "console/print/PrintComparison.hpp"
#include "console/print/PrintText.hpp"

#include "calibration/Prediction.hpp"
#include "command-line/OptionChecks.hpp"
#include "setups/LeftOut.hpp"
#include "setups/Mending.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <optional>

namespace naocal {

namespace {

struct CompareCommand {
  std::string result, against, json;
  std::vector<std::string> sets;
  bool samePlace = false, skipBad = false;
};

/// Comparison of two results on the same captures, with the noise estimated by the first.
struct Versus {
  double own = 0, other = 0; // px per corner, weighted with the joints' random errors
  double otherRms = 0;       // [px]
};

Versus compareTwo(const StoredResult& result, const StoredResult& other, const LoadedSets& given, bool samePlace) {
  const auto error = [&](const StoredResult& one) {
    return weightedError(one, given.sets, given.robot, samePlace, result.noise);
  };
  return {error(result), error(other), compare(other, given.sets, given.robot, samePlace).all.rmsPx};
}

void compareSets(const CompareCommand& command) {
  StoredResult result = readResult(command.result);
  LoadedSets given = loadSets(command.sets, command.skipBad);
  std::erase_if(result.inputs.setUps, isLeftOut); // of its own captures
  mendSetUps(result.inputs.setUps, given.robot, given.sets);
  const Comparison comparison = compare(result, given.sets, given.robot, command.samePlace);
  nlohmann::json json = comparisonJson(comparison);
  std::optional<Versus> versus;
  if (!command.against.empty()) {
    versus = compareTwo(result, readResult(command.against), given, command.samePlace);
    json["against"] = {{"rmsPx", versus->otherRms}, {"weightedPx", versus->other}};
    json["weightedPx"] = versus->own;
  }
  if (!command.json.empty()) {
    writeJson(json, command.json);
  }
  if (command.json == "-") {
    return;
  }
  printComparison(comparison);
  if (versus) {
    printText(
        "\nthe other result: {:.2f} px rms. With the joints' random errors allowed for, {:.3f} px against {:.3f} px "
        "of the other: {} predicts better\n",
        versus->otherRms, versus->own, versus->other, versus->own < versus->other ? "this one" : "the other");
  }
  if (!comparison.ignored.empty()) {
    printText("\nnot touched by these captures: {}\n", fmt::join(comparison.ignored, ", "));
  }
}

} // namespace

void addCompare(CLI::App& app) {
  auto command = std::make_shared<CompareCommand>();
  CLI::App* comparer = app.get_subcommand("compare");
  comparer->footer("Example: naocal compare result.json other-captures/");
  comparer->add_option("RESULT", command->result, "a result file of 'naocal solve'")->type_name("FILE")->required();
  comparer->add_option("SET", command->sets, "folders with captures.json")->type_name("FOLDER")->required();
  comparer->add_option("--against", command->against, "another result file: which of the two predicts better?")
      ->type_name("FILE");
  comparer->add_option("--json", command->json, "write JSON to a file, or - for standard output")
      ->type_name("FILE")
      ->check(replaceableFile("naocal-compare"));
  comparer->add_flag("--same-place", command->samePlace,
                     "use the placements of boards and feet from the result instead of fitting them");
  comparer->add_flag("--skip-bad", command->skipBad, "use the other captures when some cannot be used, and list those");
  comparer->callback([command] { compareSets(*command); });
}

} // namespace naocal
