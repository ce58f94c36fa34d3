#include "console/print/PrintFindings.hpp"

#include "console/print/PrintText.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <fmt/format.h>

namespace naocal {

namespace {

/// How to leave out what the captures do not tell, or what does not belong: " (--without jointOffset@HeadYaw)".
std::string formatOption(const Finding& finding) {
  std::string labels, option;
  for (const FindingAnswer& answer : finding.answers) {
    if (answer.action == "leave out") {
      option = answer.of == "effect" ? "--without" : "--with";
      labels += (labels.empty() ? "" : ",") + answer.what;
    }
  }
  return labels.empty() ? "" : fmt::format(" ({} {})", option, labels);
}

} // namespace

void printFindings(const std::vector<Finding>& findings) {
  constexpr std::size_t most = 3; // notes
  printText("{}{}\n", findings.front().sentence, formatOption(findings.front()));
  std::size_t notes = 0;
  for (const Finding* const finding : furtherFindings(findings)) {
    notes += finding->level == FindingLevel::note;
    if (finding->level != FindingLevel::note || notes <= most) {
      printText("  {}: {}{}\n", toString(finding->level), finding->sentence, formatOption(*finding));
    }
  }
  if (notes > most) {
    printText("  {} more notes: see 'findings' in the file\n", notes - most);
  }
}

void addFailOn(CLI::App& command, std::string& level) {
  command
      .add_option("--fail-on", level,
                  "exit code 3 if there is a finding of this level or a more serious one: stop (do not use) or act "
                  "(something is to be done)")
      ->type_name("LEVEL")
      ->check(CLI::IsMember({toString(FindingLevel::stop), toString(FindingLevel::act)}));
}

bool isAnyAsSerious(const std::vector<Finding>& findings, const std::string& level) {
  const FindingLevel least = level == toString(FindingLevel::act) ? FindingLevel::act : FindingLevel::stop;
  return std::any_of(findings.begin(), findings.end(), [&](const Finding& one) { return one.level <= least; });
}

} // namespace naocal
