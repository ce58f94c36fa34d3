#include "Hardware.hpp"
#include "RobotProcess.hpp"
#include "command-line/OptionChecks.hpp"
#include "command-line/Parsing.hpp"
#include "data/BoardFile.hpp"
#include "data/BoardListFile.hpp"
#include "hardware/simulated/SimulatedPlan.hpp"
#include "io/Failure.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/StateFolder.hpp"
#include "runs/RunFolder.hpp"

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <fmt/format.h>
#include <iostream>
#include <nlohmann/json.hpp> // to_json of the productions
#include <sys/prctl.h>
#include <unistd.h>

namespace naocal {
namespace {

struct Options {
  std::string hardware = "simulated", simulation;
  std::filesystem::path recording, boards;
  std::uint64_t seed = 1;
  pid_t parent = 0; // process that started this one; 0: whichever
  RobotProcessOptions process{configurationDirectory(), "recordings", "", std::nullopt, true};
};

/// Writes a sentence to standard error in one piece.
void say(std::string_view sentence) {
  std::clog << fmt::format("{}\n", printableText(sentence)) << std::flush;
}

/// The calibration round of a recording; a single set is its own round.
std::filesystem::path roundOf(const std::filesystem::path& recording) {
  return std::filesystem::exists(recording / "first") ? recording / "first" : recording;
}

/// Sets the size of the boards of a boards file, for the calibration.
void useBoards(const std::filesystem::path& file, RobotProcess& process) {
  nlohmann::json list = nlohmann::json::array();
  for (const Board& board : readFloorBoards(file)) {
    list.push_back(nlohmann::json(toJson(board, nullptr)));
  }
  process.configuration().set("Brain.CalibrationRunner", "boards", list);
}

/// The same boards before a simulated robot, which stay where its poses need them.
void lay(const std::filesystem::path& file, SimulatedPlan& plan) {
  for (const Board& board : readFloorBoards(file)) {
    for (Board& laid : plan.boards) {
      if (laid.id == board.id && board.pattern) {
        laid.pattern = board.pattern;
        laid.points = board.points;
      }
    }
  }
}

/// Replays with the recorded configuration, into a new recording.
Hardware replay(Options& options) {
  if (options.recording.empty()) {
    throw InputError{"--hardware replay: expected what to replay, such as --recording recordings/2026-01-31_12-00-00"};
  }
  if (std::filesystem::exists(options.recording / "configuration")) {
    options.process.configuration = options.recording / "configuration";
  }
  Hardware hardware = replayedHardware(roundOf(options.recording), options.process.configuration);
  const std::string name = std::filesystem::canonical(options.recording).filename().string() + "-replayed";
  std::filesystem::path folder = options.process.recordings / name;
  for (int again = 2; std::filesystem::exists(folder); ++again) {
    folder = options.process.recordings / fmt::format("{}-{}", name, again);
  }
  options.process.recordings = folder;
  options.process.state = folder / "state"; // other robots' saved settings do not apply to a recording
  options.process.replay = hardware.replay.get();
  options.process.onlyHere = true; // access.json is the robot's and must not open this computer
  return hardware;
}

Hardware hardwareOf(Options& options) {
  if (options.hardware == "v5" || options.hardware == "v6") {
    return naoHardware(options.hardware == "v5" ? "V5" : "V6", options.process.configuration);
  }
  if (options.hardware == "replay") {
    return replay(options);
  }
  SimulatedPlan plan = simulatedPlan(options.seed, options.process.configuration);
  if (!options.boards.empty()) {
    lay(options.boards, plan);
  }
  return simulatedHardware(options.simulation.empty() ? plan : readSimulatedPlan(options.simulation, plan),
                           options.process.configuration);
}

/// Has the kernel send SIGTERM when the process that started this one ends. False if it has ended already.
bool endWith(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  return ::getppid() == parent;
}

int run(Options options) {
  std::signal(SIGPIPE, SIG_IGN); // who read the log is gone: the robot still goes to its stand
  sigset_t ends;                 // blocked in all threads; sigwait below
  ::sigemptyset(&ends);
  ::sigaddset(&ends, SIGINT);
  ::sigaddset(&ends, SIGTERM);
  ::sigaddset(&ends, SIGHUP); // terminal closed
  ::pthread_sigmask(SIG_BLOCK, &ends, nullptr);
  if (options.parent != 0 && !endWith(options.parent)) {
    return 0;
  }
  const Hardware hardware = hardwareOf(options);
  const auto identity = hardware.robot->waitForIdentity(std::chrono::seconds{10});
  if (!identity) {
    throw InputError{fmt::format("the robot has not told within 10 s who it is: {}", hardware.robot->status().problem)};
  }
  if (options.process.location.empty()) {
    options.process.location = hardware.location;
  }
  if (options.process.state.empty()) {
    options.process.state = stateFolder();
  }
  removeAbandonedWrites(options.process.state);
  removeAbandonedWrites(options.process.recordings);
  say(fmt::format("What the robot learns is saved in {}, its runs in {}.", options.process.state.string(),
                  runsIn(options.process.state).string()));
  RobotProcess process{*hardware.robot, *hardware.cameras, hardware.drawing, *identity, options.process, say};
  if (!options.boards.empty()) {
    useBoards(options.boards, process);
  }
  std::atomic<bool> failed{false}, ended{false};
  process.start([&, self = ::pthread_self()](std::string_view sentence) {
    failed = !sentence.empty();
    ended = true;
    say(sentence.empty() ? "The replay is over." : sentence);
    ::pthread_kill(self, SIGTERM);
  });
  say(fmt::format("Robot {} runs{}. End it with Ctrl-C: it goes to its stand first.", identity->headId,
                  process.sockets().addressText()));
  int signal = 0;
  ::sigwait(&ends, &signal);
  const bool isOver = ended && !failed; // end of a replay
  if (!isOver && !process.goToStand(std::chrono::seconds{60})) {
    say("The robot has not come to its stand: look after it.");
  }
  process.stop();
  if (process.replayed() == nullptr) {
    return failed ? 1 : 0;
  }
  if (isOver) {
    say(process.replayed()->compareWith(roundOf(options.recording) / "result.json"));
  } else if (!failed) {
    say("The replay was stopped before its end; nothing is compared.");
  }
  return isOver ? 0 : 1;
}

} // namespace
} // namespace naocal

int main(int argc, char** argv) {
  naocal::Options options;
  CLI::App app{"The process on the robot: motion and brain threads, HULKs' debug and configuration sockets.",
               "naocal-robot"};
  naocal::useHelp(app);
  app.set_version_flag("--version", NAOCAL_VERSION, "print the version");
  app.footer("Example: naocal-robot --hardware simulated --recordings /tmp/recordings");
  app.add_option("--hardware", options.hardware, "the robot behind it")
      ->check(naocal::oneOf(std::vector<std::string>{"simulated", "v6", "v5", "replay"}))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "of a simulated robot's offsets and mounts")->capture_default_str();
  app.add_option("--recording", options.recording, "what to replay: a calibration's folder, or a capture set")
      ->type_name("FOLDER")
      ->check(naocal::existingFolder());
  app.add_option("--simulation", options.simulation,
                 "a file that says more of the simulated robot: ranges of its errors and gears' play, boards, cameras")
      ->type_name("FILE")
      ->group(naocal::expertOptions)
      ->check(naocal::existingFile());
  app.add_option(
         "--boards", options.boards,
         "boards file of 'naocal board', with the real sizes of the boards on the floor; default: as configured")
      ->type_name("FILE")
      ->check(naocal::existingFile());
  app.add_option("--configuration", options.process.configuration,
                 "folder with location/, drawings/ and poses/; it is only read")
      ->type_name("FOLDER")
      ->check(naocal::existingFolder());
  app.add_option("--state", options.process.state,
                 "folder where what the robot learns is saved, and read from again; $XDG_STATE_HOME/naocal or "
                 "~/.local/state/naocal if not given; a replay has one of its own")
      ->type_name("FOLDER");
  app.add_option("--recordings", options.process.recordings, "folder for the captures of calibrations")
      ->type_name("FOLDER")
      ->capture_default_str();
  app.add_option("--base-port", options.process.basePort,
                 "of its sockets, instead of sdk.json's: debug one above it, configuration two")
      ->type_name("PORT")
      ->group(naocal::expertOptions)
      ->check(naocal::wholeNumber(1, 65533));
  app.add_option("--parent", options.parent,
                 "process that starts this one: when it ends, however it ends, this one goes to its stand and ends too")
      ->type_name("PID")
      ->group(naocal::expertOptions)
      ->check(naocal::wholeNumber(1, 1 << 22));
  app.add_option("--location", options.process.location, "layer of the configuration beside the default")
      ->type_name("NAME")
      ->group(naocal::expertOptions);
  const auto fail = [](std::string_view sentence, int exitCode) {
    naocal::say(fmt::format("naocal-robot: {}", naocal::printableText(sentence, naocal::longestSentence)));
    return exitCode;
  };
  try {
    if (const auto done = naocal::parseCommandLine(app, argc, argv)) {
      return *done;
    }
    return naocal::run(options);
  } catch (const naocal::ConfigurationError& error) {
    return fail(error.what(), 2);
  } catch (const std::exception& error) {
    const naocal::Failure failure = naocal::describeFailure(error);
    return fail(failure.sentence, failure.exitCode);
  }
}
