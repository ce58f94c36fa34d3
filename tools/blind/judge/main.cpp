#include "judge/Page.hpp"
#include "judge/Tally.hpp"
#include "seal/Seal.hpp"

#include <CLI/CLI.hpp>
#include <exception>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace {

void print(const blind::Tally& tally) {
  fmt::print("{} sets, {:.2f} s per diagnosis{}\n\n", tally.sets, tally.seconds.value(),
             tally.withoutVerdict > 0 ? fmt::format(", {} without a verdict", tally.withoutVerdict) : "");
  fmt::print("  {:<58} {:<16} {:>9}   {:<18} {:>5}\n", "figure", "required", "measured", "95 % band", "sets");
  for (const blind::Required& figure : blind::requiredFigures(tally)) {
    if (figure.value) {
      fmt::print("{} {:<58} {:<16} {:>9.3f}   {:<18} {:>8}\n", figure.met ? " " : "!", figure.what, figure.wanted,
                 *figure.value, "", figure.share.all);
      continue;
    }
    fmt::print("{} {:<58} {:<16} {:>7.1f} %   {:>5.1f} to {:>5.1f} % {:>8}\n", figure.met ? " " : "!", figure.what,
               figure.wanted, 100 * figure.share.rate(), 100 * figure.share.low(), 100 * figure.share.high(),
               figure.share.all);
  }
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app{"blind-judge: opens sealed truths and says what answers were worth.", "blind-judge"};
  app.footer("Example: blind-judge /tmp/blind --json evaluation.json --page evaluation.html");
  std::string folder, jsonFile, pageFile;
  app.add_option("FOLDER", folder, "what blind-writer wrote, with answers/NAME.json beside it")->required();
  app.add_option("--json", jsonFile, "write the evaluation as JSON to a file, or - for standard output");
  app.add_option("--page", pageFile, "write a page with plots");
  CLI11_PARSE(app, argc, argv);
  try {
    const std::vector<blind::Case> cases = blind::readCases(folder);
    const blind::Tally tally = blind::tallyCases(cases);
    const std::string json = blind::evaluationJson(tally).dump(1) + "\n";
    if (!jsonFile.empty() && jsonFile != "-") {
      blind::writeFile(jsonFile, json);
    }
    if (!pageFile.empty()) {
      blind::writeFile(pageFile, blind::renderEvaluation(tally, cases));
    }
    if (jsonFile == "-") {
      fmt::print("{}", json);
    } else {
      print(tally);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "blind-judge: {}\n", error.what());
    return 2;
  }
  return 0;
}
