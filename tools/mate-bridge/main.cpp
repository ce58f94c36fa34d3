#include "Browser.hpp"
#include "Panel.hpp"
#include "analysis/Dataset.hpp"
#include "server/PageFiles.hpp"
#include "start/RecentFiles.hpp"

#include "command-line/OptionChecks.hpp"
#include "command-line/Parsing.hpp"
#include "io/Failure.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/StateFolder.hpp"
#include "math/Parallel.hpp"
#include "runs/RunFolder.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <filesystem>
#include <fmt/core.h>
#include <optional>

namespace {

/// The port of "127.0.0.1:PORT". Throws InputError for other addresses: the panel must not listen beyond this computer.
std::uint16_t portOf(const std::string& address) {
  constexpr std::string_view here = "127.0.0.1:";
  std::uint16_t port = 0;
  const std::string_view number = std::string_view{address}.substr(std::min(address.size(), here.size()));
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), port);
  if (!address.starts_with(here) || error != std::errc{} || end != number.data() + number.size()) {
    throw naocal::InputError{fmt::format("--listen: expected 127.0.0.1:PORT, for the panel is served to this computer "
                                         "only (from another one: ssh -L); found \"{}\"",
                                         address)};
  }
  return port;
}

/// The folder of runs in the state folder; empty, after a sentence, if there is no such folder for this user.
std::filesystem::path runsFolder(const std::string& state) {
  try {
    return naocal::runsIn(state.empty() ? naocal::stateFolder() : std::filesystem::path{state});
  } catch (const naocal::InputError& error) {
    fmt::print(stderr, "Runs of robots are not recorded: {}.\n", error.what());
    return {};
  }
}

} // namespace

int main(int argc, char** argv) {
  naocal::endWithSentence("mate-bridge");
  naocal::tuneAllocator();
  CLI::App app{"The panel: look at a calibration and at robots in a browser of this computer.", "mate-bridge"};
  naocal::useHelp(app);
  app.footer("Examples: mate-bridge captures/\n          mate-bridge result.json\n          mate-bridge "
             "diagnosis.json\n          mate-bridge --robot nao21");
  std::vector<std::string> sets, robots;
  std::string session, state;
  std::vector<std::string> lookIn;
  std::string listen = "127.0.0.1:0";
  bool noOpen = false;
  app.add_option("SET", sets,
                 "capture sets, a recording of the robot, or a result, diagnosis or session together with its captures")
      ->type_name("FILE");
  app.add_option("--session", session,
                 "keeps the models that are tried with these captures in this file, and goes on from it; so does "
                 "'naocal explore'")
      ->type_name("FILE");
  app.add_option("--robot", robots, "a robot: HOST, HOST:PORT (its base port), or the folder of its UNIX sockets")
      ->type_name("HOST")
      ->allow_extra_args(false);
  app.add_option("--listen", listen, "127.0.0.1:PORT where the panel is served; 0 takes any port")
      ->type_name("ADDRESS")
      ->capture_default_str();
  app.add_option("--look-in", lookIn,
                 "a folder to search for captures that were moved; they are recognised by their SHA-256")
      ->type_name("FOLDER")
      ->check(naocal::existingFolder())
      ->allow_extra_args(false);
  app.add_option("--state", state,
                 "folder where runs of connected robots are recorded, in runs/; $XDG_STATE_HOME/naocal or "
                 "~/.local/state/naocal if not given")
      ->type_name("FOLDER");
  app.add_flag("--no-open", noOpen, "only print the address");
  app.set_version_flag("--version", NAOCAL_VERSION, "print the version");
  try {
    if (const auto done = naocal::parseCommandLine(app, argc, argv)) {
      return *done;
    }
    naocal::PanelOptions options{std::nullopt, robots, portOf(listen), sets, naocal::recentFilesFile(), runsFolder(state)};
    options.lookIn.assign(lookIn.begin(), lookIn.end());
    if (!session.empty()) {
      naocal::removeAbandonedWritesOf(session);
      options.opened = naocal::openSession(sets, session, options.lookIn);
      options.paths = sets.empty() ? std::vector{session} : sets;
    } else if (!sets.empty()) {
      options.opened = naocal::openDataset(sets, options.lookIn);
    }
    for (const std::string& sentence : options.opened ? options.opened->moved : std::vector<std::string>{}) {
      fmt::print(stderr, "{}\n", naocal::printableText(sentence));
    }
    const std::string runs = options.runs.string();
    naocal::Panel panel{std::move(options)};
    fmt::print("The panel is at {}\n{}End with Ctrl-C.\n", panel.address(),
               runs.empty() ? "" : fmt::format("Runs of robots are recorded in {}.\n", runs));
    std::fflush(stdout);
    const bool isThere = naocal::pageMissing().empty();
    const auto opened = isThere && !noOpen ? naocal::openInBrowser(panel.address()) : nullptr;
    if (!isThere) {
      fmt::print(stderr, "{}\n", naocal::pageMissing());
    } else if (!noOpen && !opened) {
      fmt::print(stderr, "No browser was found: open the address yourself.\n");
    }
    panel.run();
    return 0;
  } catch (const std::exception& error) {
    const naocal::Failure failure = naocal::describeFailure(error);
    fmt::print(stderr, "mate-bridge: {}\n", naocal::printableText(failure.sentence, naocal::longestSentence));
    return failure.exitCode;
  }
}
