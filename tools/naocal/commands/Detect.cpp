#include "commands/Commands.hpp"
#include "console/CommandLine.hpp"
#include "console/OutputFiles.hpp"
#include "console/print/PrintText.hpp"

#include "command-line/OptionChecks.hpp"
#include "data/CaptureSetFile.hpp"
#include "detect/BoardDetector.hpp"
#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

namespace naocal {

namespace {

struct DetectCommand {
  std::string set, json;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  bool dryRun = false, skipBad = false;
};

volatile std::sig_atomic_t interrupted = 0;

/// Detections of one board.
struct BoardCount {
  std::size_t pictures = 0, corners = 0;
};

std::map<std::string, BoardCount> boardCounts(const CaptureSet& set) {
  std::map<std::string, BoardCount> counts;
  for (const Board& board : set.boards) {
    if (board.pattern) {
      counts[board.id];
    }
  }
  for (const Capture& capture : set.captures) {
    if (!capture.image.empty() && capture.corners) {
      for (const BoardCorners& corners : *capture.corners) {
        if (const auto count = counts.find(corners.board); count != counts.end()) {
          ++count->second.pictures;
          count->second.corners += corners.ids.size();
        }
      }
    }
  }
  return counts;
}

nlohmann::json detectionJson(const CaptureSet& set, const SetDetection& detection) {
  nlohmann::json document = withFormat("naocal-detection", {{"pictures", detection.pictures},
                                                            {"boards", nlohmann::json::object()},
                                                            {"findings", nlohmann::json::array()},
                                                            {"unreadable", detection.unreadable}});
  for (const auto& [board, count] : boardCounts(set)) {
    document["boards"][board] = {{"pictures", count.pictures}, {"corners", count.corners}};
  }
  for (const auto& [capture, finding] : detection.findings) {
    nlohmann::json entry{{"capture", capture}, {"kind", toString(finding.kind)}, {"sentence", finding.sentence}};
    if (!finding.board.empty()) {
      entry["board"] = finding.board;
    }
    if (finding.corner && finding.place) {
      entry["corner"] = *finding.corner;
      entry["uv"] = {finding.place->x(), finding.place->y()};
    }
    document["findings"].push_back(entry);
  }
  return document;
}

/// Captures with the same finding.
struct Remark {
  std::string sentence;
  std::vector<int> captures;
};

/// Prints a few findings of each kind, identical ones grouped; the JSON has all.
void printFindings(const SetDetection& detection) {
  constexpr std::size_t shown = 5;
  std::map<IssueKind, std::vector<Remark>> remarks;
  for (const auto& [capture, finding] : detection.findings) {
    auto& ofKind = remarks[finding.kind];
    auto same = std::find_if(ofKind.begin(), ofKind.end(), [&sentence = finding.sentence](const Remark& remark) {
      return remark.sentence == sentence;
    });
    if (same == ofKind.end()) {
      same = ofKind.insert(same, {finding.sentence, {}});
    }
    same->captures.push_back(capture);
  }
  for (const auto& [kind, ofKind] : remarks) {
    if (kind == IssueKind::hiddenCorner) {
      printText("  {} corners of boards that were found are hidden or too blurred\n", ofKind.size());
      continue;
    }
    for (std::size_t i = 0; i < std::min(shown, ofKind.size()); ++i) {
      const auto& [sentence, captures] = ofKind[i];
      printText("  {}: {}\n",
                captures.size() == 1 ? fmt::format("capture {}", captures.front())
                                     : fmt::format("{} captures", captures.size()),
                sentence);
    }
    if (ofKind.size() > shown) {
      printText("  {} more of kind {} (--json lists all)\n", ofKind.size() - shown, toString(kind));
    }
  }
}

/// For example "2 of 24 pictures cannot be used (captures 4, 9)".
std::string countUnreadable(const SetDetection& detection) {
  const std::size_t count = detection.unreadable.size(), all = detection.pictures + count;
  return fmt::format("{} of {} picture{} cannot be used (capture{} {})", count, all, all == 1 ? "" : "s",
                     count == 1 ? "" : "s", fmt::join(detection.unreadableCaptures, ", "));
}

void detectSet(const DetectCommand& command) {
  CaptureSet set = readCaptureSet(command.set).set;
  std::signal(SIGINT, [](int) { interrupted = 1; });
  const bool onTerminal = isatty(STDERR_FILENO) != 0;
  std::size_t all = 0;
  const auto start = std::chrono::steady_clock::now();
  const SetDetection detection = detectInSet(set, command.set, command.threads, [&](std::size_t done, std::size_t of) {
    all = of;
    if (onTerminal) {
      fmt::print(stderr, "\r{} of {} pictures{}", done, of, done == of ? "\n" : "");
    }
    return interrupted == 0;
  });
  std::signal(SIGINT, SIG_DFL);
  if (!detection.unreadable.empty() && !command.skipBad) {
    throw InputError{fmt::format("{}; {}, nothing was written (--skip-bad goes on with the other pictures)",
                                 detection.unreadable.front(), countUnreadable(detection))};
  }
  if (!command.dryRun) {
    removeAbandonedWritesOf(std::filesystem::path{command.set} / "captures.json");
    writeCaptureSet(set, command.set);
  }
  if (!command.json.empty()) {
    writeJson(detectionJson(set, detection), command.json);
  }
  if (command.json == "-") {
    return;
  }
  if (detection.pictures == 0 && detection.unreadable.empty() && interrupted == 0) {
    printText("no capture of {} names a picture; nothing was changed\n", command.set);
    return;
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  printText("{} pictures in {:.1f} s\n", detection.pictures, seconds.count());
  for (const auto& [board, count] : boardCounts(set)) {
    printText("  board {:<6} in {:>5} pictures, {:>7} corners\n", board, count.pictures, count.corners);
  }
  printFindings(detection);
  for (const std::string& sentence : detection.unreadable) {
    printText("  left as it was: {}\n", sentence);
  }
  if (interrupted != 0) {
    printText("stopped: {} pictures were not looked at and are left as they were\n",
              all - detection.pictures - detection.unreadable.size());
  }
  printText("{}\n", command.dryRun ? "nothing was written" : "the corners are written into the set");
  if (!detection.unreadable.empty()) {
    printText("{}: these captures are left as they were\n", countUnreadable(detection));
  }
}

} // namespace

void addDetect(CLI::App& app) {
  auto command = std::make_shared<DetectCommand>();
  CLI::App* detector = app.get_subcommand("detect");
  detector->footer("Example: naocal detect captures/ --json findings.json");
  detector->add_option("SET", command->set, "a folder with captures.json and pictures")
      ->type_name("FOLDER")
      ->required();
  detector->add_option("--json", command->json, "what was found and refused, to a file or - for standard output")
      ->type_name("FILE")
      ->check(replaceableFile("naocal-detection"));
  detector->add_option("--threads", command->threads, "how many pictures at once")
      ->group(expertOptions)
      ->check(wholeNumber(1, 1024));
  detector->add_flag("--dry-run", command->dryRun, "look, but leave the set as it is");
  detector->add_flag("--skip-bad", command->skipBad, "leave captures whose picture cannot be used as they are");
  detector->callback([command] { detectSet(*command); });
}

} // namespace naocal
