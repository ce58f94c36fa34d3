#include "console/print/PrintFindings.hpp"

#include "console/print/PrintText.hpp"

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
  constexpr std::size_t most = 3; // notes on what is weakly determined
  printText("{}{}\n", findings.front().sentence, formatOption(findings.front()));
  std::size_t notes = 0;
  for (const Finding* const finding : furtherFindings(findings)) {
    const bool isWeak = finding->kind() == "weak" && finding->level == FindingLevel::note;
    notes += isWeak;
    if (!isWeak || notes <= most) {
      printText("  {}: {}{}\n", toString(finding->level), finding->sentence, formatOption(*finding));
    }
  }
  if (notes > most) {
    printText("  {} more note{} on what is weakly determined: files of --json have all\n", notes - most,
              notes - most == 1 ? "" : "s");
  }
}

} // namespace naocal
