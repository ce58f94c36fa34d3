#include "Browser.hpp"
#include "Panel.hpp"
#include "analysis/Dataset.hpp"
#include "server/PageFiles.hpp"

#include "io/Failure.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "math/Parallel.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
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

} // namespace

int main(int argc, char** argv) {
  naocal::endWithSentence("mate-bridge");
  naocal::tuneAllocator();
  CLI::App app{"The panel: look at a calibration and at robots in a browser of this computer."};
  app.footer("Examples: mate-bridge captures/\n          mate-bridge result.json\n          mate-bridge "
             "diagnosis.json\n          mate-bridge --robot nao21");
  std::vector<std::string> sets, robots;
  std::string session;
  std::string listen = "127.0.0.1:0";
  bool noOpen = false;
  app.add_option(
      "SET", sets,
      "capture sets, a recording of the robot, or a result, diagnosis or session together with its captures");
  app.add_option("--session", session,
                 "keeps the models that are tried with these captures in this file, and goes on from it; so does "
                 "'naocal explore'");
  app.add_option("--robot", robots, "a robot: HOST, HOST:PORT (its base port), or the folder of its UNIX sockets")
      ->allow_extra_args(false);
  app.add_option("--listen", listen, "127.0.0.1:PORT where the panel is served; 0 takes any port")
      ->capture_default_str();
  app.add_flag("--no-open", noOpen, "only print the address");
  app.set_version_flag("--version", NAOCAL_VERSION);
  try {
    app.parse(argc, argv);
    naocal::PanelOptions options{std::nullopt, robots, portOf(listen)};
    if (!session.empty()) {
      naocal::removeAbandonedWritesOf(session);
      options.opened = naocal::openSession(sets, session);
    } else if (!sets.empty()) {
      options.opened = naocal::openDataset(sets);
    }
    naocal::Panel panel{std::move(options)};
    fmt::print("The panel is at {}\nEnd with Ctrl-C.\n", panel.address());
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
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      return app.exit(error); // --help, --version
    }
    fmt::print(stderr, "mate-bridge: {} (see 'mate-bridge --help')\n",
               naocal::printableText(error.what(), naocal::longestSentence));
    return 2;
  } catch (const std::exception& error) {
    const naocal::Failure failure = naocal::describeFailure(error);
    fmt::print(stderr, "mate-bridge: {}\n", naocal::printableText(failure.sentence, naocal::longestSentence));
    return failure.exitCode;
  }
}
