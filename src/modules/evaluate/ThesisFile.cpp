#include "evaluate/ThesisEvaluation.hpp"
#include "io/Files.hpp"
#include "io/JsonReader.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

constexpr std::string_view usualErrors = "6.5", largeErrors = "1..6.5"; // [deg]

constexpr std::array<std::pair<const char*, ThesisStatus>, 4> statusKeys{
    {{"success", ThesisStatus::success},
     {"localMinimum", ThesisStatus::localMinimum},
     {"noConvergence", ThesisStatus::noConvergence},
     {"solverFailure", ThesisStatus::solverFailure}}};

/// {"0.1": ..., "0.2": ...}: shares by tolerance in degrees.
template <typename Share> nlohmann::json byTolerance(const Share& share) {
  nlohmann::json result = nlohmann::json::object();
  for (std::size_t i = 0; i < toleranceCount; ++i) {
    result[fmt::format("{:.1f}", toleranceDegrees(i))] = share(i);
  }
  return result;
}

nlohmann::json cellJson(const ThesisCell& cell, ThesisSolver solver, const ThesisTally& tally,
                        const std::vector<std::string>& joints) {
  const ThesisSetting& setting = cell.setting;
  nlohmann::json result = {
      {"table", cell.table},
      {"feature", word(setting.feature)},
      {"poses", setting.poses},
      {"noise", word(setting.noise)},
      {"jointNoise", word(setting.jointNoise)},
      {"samples", setting.samples},
      {"errors", setting.largeErrors ? largeErrors : usualErrors},
      {"legs", setting.bothLegs ? "both" : "left"},
      {"places", setting.unknownPlaces ? "unknown" : "known"},
      {"chosenBy", word(setting.choice)},
      {"solver", word(solver)},
      {"thesisSolver", word(cell.solver)},
      {"thesis", cell.published ? nlohmann::json(*cell.published) : nlohmann::json()},
      {"success", byTolerance([&](std::size_t i) { return tally.successAt(i); })},
      {"limit", byTolerance([&](std::size_t i) { return tally.limitAt(i); })},
      {"secondsPerSolve", tally.seconds / static_cast<double>(std::max<std::size_t>(tally.sets, 1))}};
  for (const auto& [key, status] : statusKeys) {
    result["status"][key] = tally.status[static_cast<std::size_t>(status)];
  }
  result["counts"] = {
      {"sets", tally.sets}, {"success", tally.success}, {"draws", tally.limitDraws}, {"limit", tally.limit}};
  for (std::size_t joint = 0; joint < tally.errors.size(); ++joint) {
    result["errorCounts"][joints[joint]] = tally.errors[joint];
  }
  for (std::size_t joint = 0; joint < tally.offsets.size(); ++joint) {
    result["offsetCounts"][joints[joint]] = tally.offsets[joint];
  }
  return result;
}

template <typename Word> Word wordAt(const JsonPlace& cell, const char* key, const std::vector<Word>& all) {
  std::vector<std::string_view> words;
  for (const Word each : all) {
    words.push_back(word(each));
  }
  return all[cell.at(key).oneOf(words)];
}

ThesisSetting settingAt(const JsonPlace& cell) {
  using enum ThesisNoise;
  ThesisSetting setting;
  setting.feature = wordAt<ThesisFeature>(cell, "feature", {ThesisFeature::grid, ThesisFeature::boards});
  setting.poses = static_cast<std::size_t>(cell.at("poses").integer(1, largestNumber));
  setting.noise = wordAt<ThesisNoise>(cell, "noise", {none, pixel, joint, both});
  setting.jointNoise = wordAt<AngleNoise>(
      cell, "jointNoise", {AngleNoise::radians, AngleNoise::degrees, AngleNoise::encoder, AngleNoise::stiction});
  setting.samples = static_cast<std::size_t>(cell.at("samples").integer(1, largestNumber));
  setting.largeErrors = cell.at("errors").oneOf({usualErrors, largeErrors}) == 1;
  setting.bothLegs = cell.at("legs").oneOf({"left", "both"}) == 1;
  setting.unknownPlaces = cell.at("places").oneOf({"known", "unknown"}) == 1;
  setting.choice = wordAt<PoseChoice>(cell, "chosenBy", {PoseChoice::ours, PoseChoice::chain});
  return setting;
}

template <std::size_t size> void readCounts(const JsonPlace& list, std::array<std::size_t, size>& counts) {
  const std::vector<double> numbers = list.numbers(size, {0, 1e12, ""}, "one per tolerance or bin");
  std::transform(numbers.begin(), numbers.end(), counts.begin(),
                 [](double number) { return static_cast<std::size_t>(number); });
}

ThesisTally tallyAt(const JsonPlace& cell, const std::vector<std::string>& joints) {
  const JsonPlace counts = cell.at("counts");
  ThesisTally tally;
  tally.sets = static_cast<std::size_t>(counts.at("sets").integer(0, largestNumber));
  tally.limitDraws = static_cast<std::size_t>(counts.at("draws").integer(0, largestNumber));
  readCounts(counts.at("success"), tally.success);
  readCounts(counts.at("limit"), tally.limit);
  for (const auto& [key, status] : statusKeys) {
    tally.status[static_cast<std::size_t>(status)] =
        static_cast<std::size_t>(cell.at("status").at(key).integer(0, largestNumber));
  }
  for (const std::string& joint : joints) { // of one leg: fewer
    if (const auto errors = cell.find("errorCounts"); errors && errors->find(joint)) {
      readCounts(errors->at(joint), tally.errors.emplace_back());
    }
    if (const auto offsets = cell.find("offsetCounts"); offsets && offsets->find(joint)) {
      readCounts(offsets->at(joint), tally.offsets.emplace_back());
    }
  }
  tally.seconds = cell.at("secondsPerSolve").number({0, 1e6, "s"}) * static_cast<double>(tally.sets);
  return tally;
}

} // namespace

nlohmann::json evaluationJson(const ThesisEvaluation& evaluation) {
  nlohmann::json cells = nlohmann::json::array();
  for (const ThesisCell& cell : thesisCells()) {
    for (const ThesisSolver solver : allSolvers) {
      if (const ThesisTally* tally = evaluation.tally(cell.setting, solver)) {
        cells.push_back(cellJson(cell, solver, *tally, evaluation.joints));
      }
    }
  }
  nlohmann::json result = {{"format", "naocal-evaluation"},
                           {"version", 1},
                           {"sets", evaluation.sets},
                           {"seed", evaluation.seed},
                           {"pixelNoise", evaluation.pixel},
                           {"parts", evaluation.parts},
                           {"done", evaluation.done},
                           {"joints", evaluation.joints},
                           {"errorBins", {{"firstDegrees", firstErrorDegrees}, {"widthDegrees", errorBinDegrees}}},
                           {"offsetBins", {{"firstDegrees", firstOffsetDegrees}, {"widthDegrees", offsetBinDegrees}}},
                           {"cells", cells}};
  if (const auto best = bestReading(evaluation)) {
    result["reproduction"] = {{"jointNoise", word(best->jointNoise)},
                              {"toleranceDegrees", toleranceDegrees(best->tolerance)},
                              {"rmsDifference", best->difference},
                              {"cells", best->cells}};
  }
  return result;
}

ThesisEvaluation readEvaluation(const std::filesystem::path& file) {
  const nlohmann::json json = parseJson(fileContent(file), file.string());
  const JsonPlace top{json, file.string()};
  top.at("format").oneOf({"naocal-evaluation"});
  top.at("version").integer(1, 1);
  ThesisEvaluation result;
  const JsonPlace seed = top.at("seed");
  if (!seed.value().is_number_unsigned()) {
    seed.refuse("a whole number");
  }
  result.seed = seed.value().get<std::uint64_t>();
  result.sets = static_cast<std::size_t>(top.at("sets").integer(1, largestNumber));
  result.pixel = top.at("pixelNoise").number({0, 1000, "px"});
  result.parts = static_cast<std::size_t>(top.at("parts").integer(1, largestNumber));
  for (const JsonPlace& part : top.at("done").elements()) {
    result.done.push_back(static_cast<std::size_t>(part.integer(0, static_cast<int>(result.parts) - 1)));
  }
  for (const JsonPlace& joint : top.at("joints").elements()) {
    result.joints.push_back(joint.text());
  }
  for (const JsonPlace& cell : top.at("cells").elements()) {
    const ThesisSetting setting = settingAt(cell);
    const auto solver = wordAt<ThesisSolver>(cell, "solver", {allSolvers.begin(), allSolvers.end()});
    if (!result.tally(setting, solver)) { // a setting may be in two tables
      result.outcomes.push_back({setting, solver, tallyAt(cell, result.joints)});
    }
  }
  return result;
}

} // namespace naocal
