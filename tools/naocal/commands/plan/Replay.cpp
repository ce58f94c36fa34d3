#include "commands/Commands.hpp"
#include "console/OutputFiles.hpp"
#include "console/Progress.hpp"
#include "console/Subprocess.hpp"
#include "console/print/PrintText.hpp"

#include "calibration/result/ResultFile.hpp"
#include "command-line/OptionChecks.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "io/Programs.hpp"
#include "io/Units.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

namespace {

namespace files = std::filesystem;

struct ReplayCommand {
  std::string recording, result, output, configuration, json;

  int run() const;

private:
  files::path round() const;
  std::optional<files::path> recordedResult() const;
  std::vector<std::string> robotCommand(const files::path& into) const;
  files::path follow(const files::path& into, std::vector<std::string>& said) const;
};

/// An unknown of the replay's result, beside the recorded one.
struct ReplayedEstimate {
  std::string name; // "jointOffset@LKneePitch.o"
  std::string unit; // of the numbers
  double value = 0, sigma = 0;
  std::optional<double> recorded;
};

/// The calibration round that is replayed; a single set is its own.
files::path ReplayCommand::round() const {
  const files::path first = files::path{recording} / "first";
  return files::exists(first) ? first : files::path{recording};
}

/// The result to compare with: the given one, or the recording's; absent if there is none.
std::optional<files::path> ReplayCommand::recordedResult() const {
  const files::path file = result.empty() ? round() / "result.json" : files::path{result};
  return result.empty() && !files::exists(file) ? std::nullopt : std::optional{file};
}

std::vector<std::string> ReplayCommand::robotCommand(const files::path& into) const {
  std::vector<std::string> command{
      requireProgram("naocal-robot"), "--hardware", "replay", "--recording", recording, "--recordings", into.string()};
  if (!configuration.empty()) {
    command.insert(command.end(), {"--configuration", configuration});
  }
  return command;
}

/// Number of pictures that the replay has recorded anew in a folder.
std::size_t recordedPictures(const files::path& into) {
  std::error_code ignored;
  std::size_t count = 0;
  for (files::recursive_directory_iterator at{into, ignored}, end; !ignored && at != end; at.increment(ignored)) {
    count += at->path().extension() == ".png" ? 1 : 0;
  }
  return count;
}

/// The sentence without the program's name before it.
std::string reasonIn(const std::string& line) {
  const std::string prefix = "naocal-robot: ";
  return line.starts_with(prefix) ? line.substr(prefix.size()) : line;
}

/// Runs the robot process over the recording; returns the folder with its captures and its result. Throws InputError
/// if it refuses the recording.
files::path ReplayCommand::follow(const files::path& into, std::vector<std::string>& said) const {
  const std::size_t all = readCaptureSet(round()).set.captures.size();
  const Progress progress{"captures"};
  std::size_t shown = 0;
  const auto waiting = [&] {
    if (const std::size_t done = recordedPictures(into); done > shown && done <= all) {
      shown = done;
      progress(done, all);
    }
  };
  const auto say = [&](std::string_view line) {
    said.emplace_back(line);
    if (json != "-") {
      printText("  {}\n", line);
    }
  };
  const ProcessResult ended = followProcess(robotCommand(into), say, waiting);
  if (Progress::wasInterrupted()) {
    throw InputError{"stopped before the replay's end; nothing is compared"};
  }
  if (ended.exitCode == 2) {
    throw InputError{
        fmt::format("{}: cannot be replayed: {}", recording, said.empty() ? "no reason given" : reasonIn(said.back()))};
  }
  if (ended.exitCode != 0) {
    throw std::runtime_error{fmt::format("naocal-robot ended with {}", ended.said.empty() ? "an error" : ended.said)};
  }
  for (const auto& entry : files::directory_iterator{into}) {
    if (files::exists(entry.path() / "result.json")) {
      return entry.path();
    }
  }
  throw std::runtime_error{"naocal-robot has left no result"};
}

std::vector<ReplayedEstimate> readEstimates(const files::path& file, const std::optional<StoredResult>& recorded) {
  const nlohmann::json document = parseJson(readFile(file), file.string());
  std::vector<ReplayedEstimate> estimates;
  for (const auto& effect : document.at("effects")) {
    const std::string at = effect.at("at").get<std::string>();
    const std::string term = effect.at("effect").get<std::string>() + (at.empty() ? "" : "@" + at);
    for (const auto& [unknown, estimate] : effect.at("unknowns").items()) {
      ReplayedEstimate each{term + "." + unknown, estimate.at("unit").get<std::string>(),
                            estimate.at("value").get<double>(), estimate.at("sigma").get<double>(), std::nullopt};
      if (recorded) {
        const auto before = recorded->values.find(each.name);
        each.recorded = before == recorded->values.end() ? std::nullopt : std::optional{before->second};
      }
      estimates.push_back(std::move(each));
    }
  }
  return estimates;
}

void printEstimates(const std::vector<ReplayedEstimate>& estimates, bool isCompared) {
  printText("\n  {:<38} {:>12}     {:>10}{}\n", "unknown", "replayed", "±  1 sigma",
            isCompared ? "          recorded    difference" : "");
  for (const ReplayedEstimate& each : estimates) {
    const auto [unit, scale] = displayUnit(each.unit);
    std::string line = fmt::format("  {:<38} {:>10.4f} {:<4}  {:>8.4f} {:<4}", each.name, scale * each.value, unit,
                                   scale * each.sigma, unit);
    if (isCompared) {
      line += each.recorded ? fmt::format(" {:>10.4f} {:<4} {:>10.2g} {:<4}", scale * *each.recorded, unit,
                                          scale * (each.value - *each.recorded), unit)
                            : "          -";
    }
    printText("{}\n", line);
  }
}

nlohmann::json replayJson(const ReplayCommand& command, const std::vector<std::string>& said, bool usable,
                          const std::vector<ReplayedEstimate>& estimates) {
  nlohmann::json document = withFormat(
      "naocal-replay",
      {{"set", command.recording}, {"usable", usable}, {"said", said}, {"estimates", nlohmann::json::array()}});
  for (const ReplayedEstimate& each : estimates) {
    nlohmann::json entry{{"unknown", each.name}, {"unit", each.unit}, {"value", each.value}, {"sigma", each.sigma}};
    if (each.recorded) {
      entry["recorded"] = *each.recorded;
      entry["difference"] = each.value - *each.recorded;
    }
    document["estimates"].push_back(entry);
  }
  return document;
}

/// Sums up the differences in one sentence.
void printDifference(const std::vector<ReplayedEstimate>& estimates, const files::path& file) {
  std::size_t same = 0, compared = 0;
  const ReplayedEstimate* worst = nullptr;
  const auto inSigmas = [](const ReplayedEstimate& each) {
    return each.sigma > 0 ? std::abs(each.value - *each.recorded) / each.sigma : 0;
  };
  for (const ReplayedEstimate& each : estimates) {
    if (each.recorded) {
      ++compared;
      same += each.value == *each.recorded ? 1 : 0;
      worst = worst == nullptr || inSigmas(each) > inSigmas(*worst) ? &each : worst;
    }
  }
  if (worst == nullptr) {
    printText("\n{} has none of these unknowns\n", file.string());
  } else if (same == compared) {
    printText("\nall {} estimates that {} has are the same, bit for bit\n", compared, file.string());
  } else {
    printText("\n{} of {} estimates differ from {}, at most by {:.2g} sigma ({})\n", compared - same, compared,
              file.string(), inSigmas(*worst), worst->name);
  }
}

int ReplayCommand::run() const {
  if (!output.empty() && files::exists(output) && (!files::is_directory(output) || !files::is_empty(output))) {
    throw InputError{fmt::format("{}: expected a new or empty folder for the replay, found something there; it is left "
                                 "alone, name another one",
                                 output)};
  }
  const auto file = recordedResult();
  const std::optional<StoredResult> recorded = file ? std::optional{readResult(*file)} : std::nullopt;
  std::optional<TemporaryDirectory> temporary;
  if (output.empty()) {
    temporary.emplace();
  }
  std::vector<std::string> said;
  const files::path into = temporary ? temporary->path() : files::path{output};
  const files::path folder = follow(into, said);
  const StoredResult replayed = readResult(folder / "result.json");
  const std::vector<ReplayedEstimate> estimates = readEstimates(folder / "result.json", recorded);
  if (!json.empty()) {
    writeJson(replayJson(*this, said, replayed.usable, estimates), json);
  }
  if (json != "-") {
    printEstimates(estimates, recorded.has_value());
    if (file) {
      printDifference(estimates, *file);
    }
    if (!output.empty()) {
      printText("{} holds captures and result of the replay\n", folder.string());
    }
    if (!replayed.usable) {
      printText("Do not use this result: naocal solve {} says why\n", round().string());
    }
  }
  return replayed.usable ? 0 : 3;
}

} // namespace

void addReplay(CLI::App& app, int& exitCode) {
  const auto command = std::make_shared<ReplayCommand>();
  CLI::App* const replay = app.get_subcommand("replay");
  replay->footer("Example: naocal replay recordings/2026-02-14_10-05-00\n"
                 "         naocal replay captures/ --result result.json");
  replay->add_option("SET", command->recording, "a capture set with pictures, or a calibration's folder")
      ->type_name("FOLDER")
      ->required()
      ->check(existingFolder());
  replay->add_option("--result", command->result, "result to compare with; default: the recording's own, if it has one")
      ->type_name("FILE")
      ->check(existingFile());
  replay->add_option("-o,--output", command->output, "new folder for captures and result of the replay; default: none")
      ->type_name("FOLDER");
  replay
      ->add_option("--configuration", command->configuration,
                   "the robot's configuration; default: as recorded, otherwise as shipped")
      ->type_name("FOLDER")
      ->check(existingFolder());
  replay->add_option("--json", command->json, "write what came out to this file, or - for standard output")
      ->type_name("FILE")
      ->check(replaceableFile("naocal-replay"));
  replay->callback([command, &exitCode] { exitCode = command->run(); });
}

} // namespace naocal
