#include "commands/Commands.hpp"
#include "console/CommandLine.hpp"
#include "console/OutputFiles.hpp"
#include "console/PrintText.hpp"

#include "command-line/OptionChecks.hpp"
#include "report/ReportPage.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <memory>
#include <string>
#include <vector>

namespace naocal {

namespace {

struct ReportCommand {
  std::string file, output;
  std::vector<std::string> lookIn;
};

} // namespace

void addReport(CLI::App& app) {
  auto command = std::make_shared<ReportCommand>();
  CLI::App* reporter = app.get_subcommand("report");
  reporter->footer("Example: naocal report result.json -o report.html");
  reporter
      ->add_option(
          "FILE", command->file,
          "a result of 'naocal solve', a diagnosis of 'naocal diagnose' or what 'naocal evaluate thesis --json' writes")
      ->type_name("FILE")
      ->required();
  reporter->add_option("-o,--output", command->output, "the page to write")
      ->type_name("FILE")
      ->required()
      ->check(replaceableFile(std::string{pageFormat}));
  addLookIn(*reporter, command->lookIn);
  reporter->callback([command] {
    const std::string page =
        renderReport(command->file, {{command->lookIn.begin(), command->lookIn.end()},
                                     [](const std::string& sentence) { printText(stderr, "{}\n", sentence); }});
    writePage(command->output, page);
    printText("written to {} ({:.1f} MB): open it in any browser\n", command->output, 1e-6 * double(page.size()));
  });
}

} // namespace naocal
