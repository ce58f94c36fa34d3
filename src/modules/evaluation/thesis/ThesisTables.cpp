#include "evaluation/thesis/ThesisTables.hpp"

#include "evaluation/Proportion.hpp"
#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
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

/// Mean residuals on the floor and the poses' fields of view [m].
nlohmann::json residualsJson(const ThesisOutcome& outcome) {
  nlohmann::json squares = nlohmann::json::array(), views = nlohmann::json::array();
  for (const ResidualMap::Square& square : outcome.tally.residuals.squares()) {
    squares.push_back({square.x, square.y, square.count, std::round(1000 * square.sum) / 1000});
  }
  for (const auto& view : outcome.fieldsOfView) {
    nlohmann::json corners = nlohmann::json::array();
    for (const Eigen::Vector2d& corner : view) {
      corners.push_back({corner.x(), corner.y()});
    }
    views.push_back(corners);
  }
  return {{"squareMetres", ResidualMap::width}, {"squares", squares}, {"fieldsOfView", views}};
}

nlohmann::json cellJson(const ThesisCell& cell, const ThesisOutcome& outcome, const std::vector<std::string>& joints) {
  const ThesisSetting& setting = cell.setting;
  const ThesisTally& tally = outcome.tally;
  nlohmann::json result = {
      {"table", cell.table},
      {"feature", toString(setting.feature)},
      {"poses", setting.poses},
      {"noise", toString(setting.noise)},
      {"jointNoise", toString(setting.jointNoise)},
      {"samples", setting.samples},
      {"errors", setting.largeErrors ? largeErrors : usualErrors},
      {"legs", setting.bothLegs ? "both" : "left"},
      {"places", setting.unknownPlaces ? "unknown" : "known"},
      {"chosenBy", toString(setting.choice)},
      {"errorSets", toString(setting.errorSets)},
      {"solver", toString(outcome.solver)},
      {"thesisSolver", toString(cell.solver)},
      {"thesis", cell.published ? nlohmann::json(*cell.published) : nlohmann::json()},
      {"success", byTolerance([&](std::size_t i) { return tally.successAt(i); })},
      {"limit", byTolerance([&](std::size_t i) { return tally.limitAt(i); })},
      {"secondsPerSolve", tally.seconds / static_cast<double>(std::max<std::size_t>(tally.sets, 1))}};
  for (const auto& [key, status] : statusKeys) {
    result["status"][key] = tally.status[static_cast<std::size_t>(status)];
  }
  result["counts"] = {
      {"sets", tally.sets}, {"success", tally.success}, {"draws", tally.limitDraws}, {"limit", tally.limit}};
  if (setting.likeProgram()) {
    result["residuals"] = residualsJson(outcome);
  }
  if (tally.restarts > 0) {
    result["restartedFailures"] = {{"failures", tally.restarts}, {"reached", tally.reached}, {"ranOut", tally.ranOut}};
  }
  for (std::size_t joint = 0; joint < tally.errors.size(); ++joint) {
    result["errorCounts"][joints[joint]] = tally.errors[joint];
  }
  for (std::size_t joint = 0; joint < tally.offsets.size(); ++joint) {
    result["offsetCounts"][joints[joint]] = tally.offsets[joint];
  }
  return result;
}

template <typename Word> Word wordAt(const JsonCursor& cell, const char* key, const std::vector<Word>& all) {
  std::vector<std::string_view> words;
  for (const Word each : all) {
    words.push_back(toString(each));
  }
  return all[cell.at(key).wordIndex(words)];
}

ThesisSetting settingAt(const JsonCursor& cell) {
  using enum ThesisNoise;
  ThesisSetting setting;
  setting.feature = wordAt<ThesisFeature>(cell, "feature",
                                          {ThesisFeature::grid, ThesisFeature::boards, ThesisFeature::programGrid,
                                           ThesisFeature::fourBoards, ThesisFeature::eightBoards, ThesisFeature::file});
  setting.poses = static_cast<std::size_t>(cell.at("poses").integer(1, maxInteger));
  setting.noise = wordAt<ThesisNoise>(cell, "noise", {none, pixel, joint, both});
  setting.jointNoise = wordAt<AngleNoise>(
      cell, "jointNoise",
      {AngleNoise::radians, AngleNoise::degrees, AngleNoise::encoder, AngleNoise::stiction, AngleNoise::unrounded});
  setting.samples = static_cast<std::size_t>(cell.at("samples").integer(1, maxInteger));
  setting.largeErrors = cell.at("errors").wordIndex({usualErrors, largeErrors}) == 1;
  setting.bothLegs = cell.at("legs").wordIndex({"left", "both"}) == 1;
  setting.unknownPlaces = cell.at("places").wordIndex({"known", "unknown"}) == 1;
  setting.choice = wordAt<PoseChoice>(cell, "chosenBy",
                                      {PoseChoice::ours, PoseChoice::chain, PoseChoice::program, PoseChoice::file});
  if (cell.find("errorSets")) { // absent in files of earlier versions
    setting.errorSets = wordAt<ErrorSets>(cell, "errorSets", {ErrorSets::uniform, ErrorSets::program, ErrorSets::file});
  }
  return setting;
}

template <std::size_t size> void readCounts(const JsonCursor& list, std::array<std::size_t, size>& counts) {
  const std::vector<double> numbers = list.numbers(size, {0, 1e12, ""}, "one per tolerance or bin");
  std::transform(numbers.begin(), numbers.end(), counts.begin(),
                 [](double number) { return static_cast<std::size_t>(number); });
}

ThesisTally tallyAt(const JsonCursor& cell, const std::vector<std::string>& joints) {
  const JsonCursor counts = cell.at("counts");
  ThesisTally tally;
  tally.sets = static_cast<std::size_t>(counts.at("sets").integer(0, maxInteger));
  tally.limitDraws = static_cast<std::size_t>(counts.at("draws").integer(0, maxInteger));
  readCounts(counts.at("success"), tally.success);
  readCounts(counts.at("limit"), tally.limit);
  for (const auto& [key, status] : statusKeys) {
    tally.status[static_cast<std::size_t>(status)] =
        static_cast<std::size_t>(cell.at("status").at(key).integer(0, maxInteger));
  }
  for (const std::string& joint : joints) { // fewer for one leg
    if (const auto errors = cell.find("errorCounts"); errors && errors->find(joint)) {
      readCounts(errors->at(joint), tally.errors.emplace_back());
    }
    if (const auto offsets = cell.find("offsetCounts"); offsets && offsets->find(joint)) {
      readCounts(offsets->at(joint), tally.offsets.emplace_back());
    }
  }
  if (const auto restarted = cell.find("restartedFailures")) {
    tally.restarts = static_cast<std::size_t>(restarted->at("failures").integer(0, maxInteger));
    tally.reached = static_cast<std::size_t>(restarted->at("reached").integer(0, maxInteger));
    tally.ranOut = static_cast<std::size_t>(restarted->at("ranOut").integer(0, maxInteger));
  }
  if (const auto residuals = cell.find("residuals")) {
    for (const JsonCursor& square : residuals->at("squares").elements()) {
      const std::vector<double> numbers = square.numbers(4, anyNumber, "x, y, count and sum");
      tally.residuals.add({static_cast<int>(numbers[0]), static_cast<int>(numbers[1]),
                           static_cast<std::size_t>(std::max(0.0, numbers[2])), numbers[3]});
    }
  }
  tally.seconds = cell.at("secondsPerSolve").number({0, 1e6, "s"}) * static_cast<double>(tally.sets);
  return tally;
}

std::vector<std::array<Eigen::Vector2d, 4>> fieldsOfViewAt(const JsonCursor& cell) {
  std::vector<std::array<Eigen::Vector2d, 4>> views;
  if (const auto residuals = cell.find("residuals")) {
    for (const JsonCursor& view : residuals->at("fieldsOfView").elements()) {
      const std::vector<JsonCursor> corners = view.elements();
      if (corners.size() != 4) {
        view.refuse("four corners", fmt::format("{}", corners.size()));
      }
      std::array<Eigen::Vector2d, 4>& last = views.emplace_back();
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::vector<double> point = corners[i].numbers(2, {-100, 100, "m"}, "x and y");
        last[i] = {point[0], point[1]};
      }
    }
  }
  return views;
}

/// Bin index of an angle [rad]; clamps to the outermost bins.
std::size_t binOf(double angle, double first, double width, std::size_t bins) {
  const double bin = std::floor((degrees(angle) - first) / width);
  return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(bins - 1)));
}

template <typename Bins> void addBins(const std::vector<Bins>& more, std::vector<Bins>& sum) {
  sum.resize(std::max(sum.size(), more.size()));
  for (std::size_t joint = 0; joint < more.size(); ++joint) {
    for (std::size_t bin = 0; bin < more[joint].size(); ++bin) {
      sum[joint][bin] += more[joint][bin];
    }
  }
}

} // namespace

std::size_t ThesisEvaluation::setsOf(ThesisSolver solver) const {
  switch (solver) {
  case ThesisSolver::numeric:
    return std::min(sets, 10 * others);
  case ThesisSolver::dlib:
  case ThesisSolver::swarm:
    return std::min(sets, others);
  case ThesisSolver::plain:
  case ThesisSolver::randomStarts:
  case ThesisSolver::ours:
  case ThesisSolver::program:
  case ThesisSolver::programStarts:
    break;
  }
  return sets;
}

const ThesisTally* ThesisEvaluation::tally(const ThesisSetting& setting, ThesisSolver solver) const {
  const auto found = std::find_if(outcomes.begin(), outcomes.end(), [&](const ThesisOutcome& outcome) {
    return outcome.setting == setting && outcome.solver == solver;
  });
  return found == outcomes.end() ? nullptr : &found->tally;
}

ThesisEvaluation mergeEvaluations(const std::vector<ThesisEvaluation>& parts) {
  ThesisEvaluation result = parts.front();
  for (auto part = parts.begin() + 1; part != parts.end(); ++part) {
    if (part->inputs != result.inputs) {
      throw InputError{"expected parts of one evaluation, found parts with different input files"};
    }
    if (part->seed != result.seed || part->sets != result.sets || part->pixel != result.pixel ||
        part->parts != result.parts) {
      throw InputError{fmt::format("expected parts of one evaluation (seed {}, {} sets, {} px, {} parts), found one of "
                                   "seed {}, {} sets, {} px, {} parts",
                                   result.seed, result.sets, result.pixel, result.parts, part->seed, part->sets,
                                   part->pixel, part->parts)};
    }
    result.joints =
        result.joints.size() < part->joints.size() ? part->joints : result.joints; // a part may have stopped early
    for (const std::size_t done : part->done) {
      if (std::find(result.done.begin(), result.done.end(), done) != result.done.end()) {
        throw InputError{fmt::format("expected every part once, found {}/{} twice", done, result.parts)};
      }
      result.done.push_back(done);
    }
    for (const ThesisOutcome& outcome : part->outcomes) {
      const auto same = std::find_if(result.outcomes.begin(), result.outcomes.end(), [&](const ThesisOutcome& other) {
        return outcome.setting == other.setting && outcome.solver == other.solver;
      });
      if (same != result.outcomes.end()) {
        same->tally.add(outcome.tally);
      } else {
        result.outcomes.push_back(outcome);
      }
    }
  }
  std::sort(result.done.begin(), result.done.end());
  return result;
}

std::optional<NoiseInterpretation> bestInterpretation(const ThesisEvaluation& evaluation) {
  std::optional<NoiseInterpretation> best;
  for (const AngleNoise reading : {AngleNoise::radians, AngleNoise::degrees, AngleNoise::encoder}) {
    for (std::size_t tolerance = 0; tolerance < toleranceCount; ++tolerance) {
      double squares = 0;
      std::size_t cells = 0;
      for (const ThesisCell& cell : thesisCells()) {
        const ThesisTally* tally = evaluation.tally(cell.setting, cell.solver);
        if (tally && cell.setting.angleNoise() && cell.setting.jointNoise == reading &&
            cell.published.value_or(0) > 0) {
          squares += std::pow(tally->successAt(tolerance) - *cell.published, 2);
          ++cells;
        }
      }
      const double difference = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(cells, 1)));
      if (cells > 0 && (!best || difference < best->difference)) {
        best = {reading, tolerance, difference, cells};
      }
    }
  }
  return best;
}

std::vector<ThesisCell> cellsOf(const ThesisEvaluation& evaluation) {
  std::vector<ThesisCell> cells = thesisCells();
  const auto has = [&](const ThesisSetting& setting) {
    return std::any_of(cells.begin(), cells.end(), [&](const ThesisCell& cell) { return cell.setting == setting; });
  };
  for (const ThesisOutcome& outcome : evaluation.outcomes) {
    if (!has(outcome.setting)) {
      cells.push_back({"files", outcome.setting, ThesisSolver::program, std::nullopt});
    }
  }
  return cells;
}

RestartedFailures restartedFailures(const ThesisEvaluation& evaluation) {
  RestartedFailures sum;
  for (const ThesisOutcome& outcome : evaluation.outcomes) {
    sum.failures += outcome.tally.restarts;
    sum.reached += outcome.tally.reached;
    sum.ranOut += outcome.tally.ranOut;
  }
  return sum;
}

nlohmann::json evaluationJson(const ThesisEvaluation& evaluation) {
  nlohmann::json cells = nlohmann::json::array();
  for (const ThesisCell& cell : cellsOf(evaluation)) {
    for (const ThesisSolver solver : allSolvers) {
      for (const ThesisOutcome& outcome : evaluation.outcomes) {
        if (outcome.setting == cell.setting && outcome.solver == solver) {
          cells.push_back(cellJson(cell, outcome, evaluation.joints));
        }
      }
    }
  }
  nlohmann::json result = withFormat(
      "naocal-evaluation", {{"sets", evaluation.sets},
                            {"seed", evaluation.seed},
                            {"pixelNoise", evaluation.pixel},
                            {"parts", evaluation.parts},
                            {"done", evaluation.done},
                            {"joints", evaluation.joints},
                            {"inputs", evaluation.inputs},
                            {"errorBins", {{"firstDegrees", firstErrorDegrees}, {"widthDegrees", errorBinDegrees}}},
                            {"offsetBins", {{"firstDegrees", firstOffsetDegrees}, {"widthDegrees", offsetBinDegrees}}},
                            {"cells", cells}});
  if (const auto [failures, reached, ranOut] = restartedFailures(evaluation); failures > 0) {
    const Proportion share = proportion(reached, failures);
    result["restartedFailures"] = {
        {"failures", failures}, {"reached", reached}, {"ranOut", ranOut}, {"interval", {share.low, share.high}}};
  }
  if (const auto best = bestInterpretation(evaluation)) {
    result["reproduction"] = {{"jointNoise", toString(best->jointNoise)},
                              {"toleranceDegrees", toleranceDegrees(best->tolerance)},
                              {"rmsDifference", best->difference},
                              {"cells", best->cells}};
  }
  return result;
}

ThesisEvaluation readEvaluation(const std::filesystem::path& file) {
  const nlohmann::json json = parseJson(readFile(file), file.string());
  const JsonCursor top{json, file.string()};
  requireFormat(top, "naocal-evaluation");
  ThesisEvaluation result;
  const JsonCursor seed = top.at("seed");
  if (!seed.value().is_number_unsigned()) {
    seed.refuse("a whole number");
  }
  result.seed = seed.value().get<std::uint64_t>();
  result.sets = static_cast<std::size_t>(top.at("sets").integer(1, maxInteger));
  result.pixel = top.at("pixelNoise").number({0, 1000, "px"});
  result.parts = static_cast<std::size_t>(top.at("parts").integer(1, maxInteger));
  for (const JsonCursor& part : top.at("done").elements()) {
    result.done.push_back(static_cast<std::size_t>(part.integer(0, static_cast<int>(result.parts) - 1)));
  }
  for (const JsonCursor& joint : top.at("joints").elements()) {
    result.joints.push_back(joint.text());
  }
  if (const auto inputs = top.find("inputs")) { // absent in files of earlier versions
    for (const auto& [option, hash] : inputs->members()) {
      result.inputs[option] = hash.text();
    }
  }
  for (const JsonCursor& cell : top.at("cells").elements()) {
    const ThesisSetting setting = settingAt(cell);
    const auto solver = wordAt<ThesisSolver>(cell, "solver", {allSolvers.begin(), allSolvers.end()});
    if (!result.tally(setting, solver)) { // a setting may occur in two tables
      result.outcomes.push_back({setting, solver, tallyAt(cell, result.joints), fieldsOfViewAt(cell)});
    }
  }
  return result;
}

void ThesisTally::add(const Eigen::VectorXd& offset, const ThesisSolution& answer,
                      const std::vector<double>& limitErrors) {
  ++sets;
  ++status[static_cast<std::size_t>(answer.status(radians(toleranceDegrees(statusTolerance))))];
  limitDraws += limitErrors.size();
  errors.resize(std::max(errors.size(), static_cast<std::size_t>(answer.errors.size())));
  for (std::size_t joint = 0; joint < static_cast<std::size_t>(answer.errors.size()); ++joint) {
    ++errors[joint][binOf(answer.errors[eigenIndex(joint)], firstErrorDegrees, errorBinDegrees, errorBins)];
  }
  offsets.resize(static_cast<std::size_t>(offset.size()));
  for (std::size_t joint = 0; joint < offsets.size(); ++joint) {
    ++offsets[joint][binOf(offset[eigenIndex(joint)], firstOffsetDegrees, offsetBinDegrees, offsetBins)];
  }
  for (std::size_t i = 0; i < toleranceCount; ++i) {
    const double tolerance = radians(toleranceDegrees(i));
    success[i] += answer.status(tolerance) == ThesisStatus::success;
    limit[i] += static_cast<std::size_t>(
        std::count_if(limitErrors.begin(), limitErrors.end(), [&](double error) { return error <= tolerance; }));
  }
}

void ThesisTally::add(const ThesisTally& other) {
  sets += other.sets;
  limitDraws += other.limitDraws;
  seconds += other.seconds;
  restarts += other.restarts;
  reached += other.reached;
  ranOut += other.ranOut;
  residuals.add(other.residuals);
  addBins(other.errors, errors);
  addBins(other.offsets, offsets);
  for (std::size_t i = 0; i < status.size(); ++i) {
    status[i] += other.status[i];
  }
  for (std::size_t i = 0; i < toleranceCount; ++i) {
    success[i] += other.success[i];
    limit[i] += other.limit[i];
  }
}

double ThesisTally::successAt(std::size_t tolerance) const {
  return sets > 0 ? static_cast<double>(success[tolerance]) / static_cast<double>(sets) : 0;
}

double ThesisTally::limitAt(std::size_t tolerance) const {
  return limitDraws > 0 ? static_cast<double>(limit[tolerance]) / static_cast<double>(limitDraws) : 0;
}

} // namespace naocal
