#include "console/print/PrintDiagnosis.hpp"

#include "console/print/PrintFindings.hpp"
#include "console/print/PrintText.hpp"
#include "diagnosis/DiagnosisWording.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <string>

namespace naocal {

namespace {

std::string bar(double value, double most, std::size_t width) {
  const double eighths = most > 0 ? std::max(0.0, value / most) * static_cast<double>(width) * 8 : 0;
  const auto full = static_cast<std::size_t>(eighths / 8);
  static const char* const parts[] = {"", "▏", "▎", "▍", "▌", "▋", "▊", "▉"};
  std::string result;
  for (std::size_t i = 0; i < full; ++i) {
    result += "█";
  }
  const std::size_t rest = full < width ? static_cast<std::size_t>(eighths) % 8 : 0;
  result += parts[rest];
  return result + std::string(width - std::min(width, full + (rest > 0 ? 1 : 0)), ' ');
}

void printLadder(const Diagnosis& diagnosis) {
  const bool unseen = diagnosis.steps.front().heldOutPx.has_value();
  printText("\n{}\n", unseen ? "held-out error: on poses that neither the fit nor the choice of effects has seen"
                             : "error of the fit (one pose: none is left to hold out)");
  const auto error = [](const SelectionStep& step) { return step.heldOutPx.value_or(step.rmsPx); };
  double most = diagnosis.steps.back().noiseFloorPx;
  for (const SelectionStep& step : diagnosis.steps) {
    most = std::max(most, error(step));
  }
  for (const SelectionStep& step : diagnosis.steps) {
    printText("  {:32} {} {:6.3f} {}{}\n", step.added.empty() ? "base model" : "+ " + step.added,
              bar(error(step), most, 30), diagnosis.unit.perPx * error(step), diagnosis.unit.name,
              step.dropped.empty() ? "" : fmt::format("   no longer needed: {}", fmt::join(step.dropped, ", ")));
  }
  const double floor = diagnosis.steps.back().noiseFloorPx;
  printText("  {:32} {} {:6.3f} {}\n", "noise floor", bar(floor, most, 30), diagnosis.unit.perPx * floor,
            diagnosis.unit.name);
}

void printCurves(const Diagnosis& diagnosis) {
  if (diagnosis.verdict != Verdict::unknownEffect) {
    return;
  }
  printText("\nunexplained rest, by joint and what it varies with\n");
  for (const DriverCurve& curve : diagnosis.driverCurves) {
    std::string coefficients;
    for (const auto& [name, value, unit] : curve.coefficients) {
      coefficients +=
          fmt::format("{}{} = {:.4g}{}", coefficients.empty() ? "" : ", ", name, value, unit == "1" ? "" : " " + unit);
    }
    const std::string like = curve.about.empty() ? fmt::format("{}  ({})", curve.expression, coefficients)
                             : curve.unit == "rad"
                                 ? fmt::format("the camera's mount turns about its {} axis", curve.about)
                                 : fmt::format("corners are off along {}", curve.about);
    printText("  {:16} over {:18} {:>9}  evidence {:7.1f}   {}\n", curve.place, curve.driver, formatAmplitude(curve),
              curve.bayes, like);
  }
}

} // namespace

void printCandidates(const Diagnosis& diagnosis, std::size_t rows, bool areNumbered) {
  double most = 0;
  for (const CandidateFinding& finding : diagnosis.ranking) {
    most = std::max(most, finding.evidence.bayes);
  }
  printText("\ncandidates, most plausible first (bar and number: evidence, 2 ln of the Bayes factor against the model "
            "without it)\n");
  for (std::size_t i = 0; i < std::min(rows, diagnosis.ranking.size()); ++i) {
    const CandidateFinding& finding = diagnosis.ranking[i];
    if (finding.state == CandidateState::noData) {
      break;
    }
    const std::string fall = finding.chi2Drop ? fmt::format("; chi2 fell by {:.0f} on adding it, predicted {:.0f}",
                                                            *finding.chi2Drop, finding.evidence.likelihoodRatio)
                                              : "";
    printText("  {}{:32} {} {:8.1f}  {:19} {}{}\n", areNumbered ? fmt::format("{:<4}", i + 1) : "",
              finding.term.label(), bar(std::max(0.0, finding.evidence.bayes), most, 14), finding.evidence.bayes,
              describeState(shownState(finding, diagnosis)), formatSizes(finding), fall);
  }
  std::size_t absorbed = 0, noData = 0, inconclusive = 0;
  for (const CandidateFinding& finding : diagnosis.ranking) {
    absorbed += finding.state == CandidateState::absorbed;
    noData += finding.state == CandidateState::noData;
    inconclusive += finding.state == CandidateState::inconclusive;
  }
  printText(
      "  {} candidates in all: {} not testable with these poses, {} without recorded data, {} undecided (they may be "
      "present, but too small to be seen here)\n",
      diagnosis.ranking.size(), absorbed, noData, inconclusive);
}

void printCandidate(const CandidateFinding& finding, const Diagnosis& diagnosis) {
  const auto line = [](const char* what, const std::string& words) {
    if (!words.empty()) {
      printText("  {:22} {}\n", what, words);
    }
  };
  const auto error = [&](const std::optional<double>& px) {
    return px ? fmt::format("{:.3f} {}", diagnosis.unit.perPx * *px, diagnosis.unit.name) : "-";
  };
  printText("{}: {}\n", finding.term.label(), finding.term.effect.description);
  line("state", describeState(shownState(finding, diagnosis)));
  if (finding.state == CandidateState::noData) {
    line("why", finding.why);
    return;
  }
  line("size", formatSizes(finding) + (finding.plausible ? "" : "; larger than plausible"));
  const std::string detectable = formatDetectable(finding);
  line("smallest detectable", detectable.empty() ? "" : detectable + " (90 % power)");
  constexpr double leastP = 1e-99; // smaller ones tell no more
  const double p = finding.evidence.pValue;
  line("evidence", fmt::format("{:.1f} (2 ln of the Bayes factor); p {} {:.2g} as a single candidate",
                               finding.evidence.bayes, p < leastP ? "<" : "=", std::max(p, leastP)));
  line("chi2", fmt::format("would fall by {:.1f}{}", finding.evidence.likelihoodRatio,
                           finding.chi2Drop ? fmt::format("; fell by {:.1f} on refitting", *finding.chi2Drop) : ""));
  line("moves corners by", // computed for likely effects only
       finding.evidence.movedPx > 0 ? fmt::format("{:.3f} px rms", finding.evidence.movedPx) : "");
  line("signature", fmt::format("{:.0f} % of it is unique; other parameters can mimic the rest",
                                100 * finding.evidence.keptFraction));
  if (finding.heldOutBefore && finding.heldOutAfter) {
    line("held-out error", error(finding.heldOutBefore) + " -> " + error(finding.heldOutAfter));
  }
  line("cannot be told from", fmt::format("{}", fmt::join(finding.equivalent, ", ")));
}

void printDiagnosis(const Diagnosis& diagnosis, const GivenOptions& asked) {
  printText("{}: ", toString(diagnosis.verdict));
  printFindings(diagnosis.findings);
  if (!diagnosis.steps.empty()) { // otherwise no fit was possible
    printLadder(diagnosis);
    printCandidates(diagnosis);
    printCurves(diagnosis);
  }
  if (const auto setUps = mendableSetUps(diagnosis); !setUps.empty()) {
    printText("\nmend it:  naocal solve {} -o result.json\n", asked.commandLine(setUps));
  }
  if (!diagnosis.suggested.empty() && !diagnosis.own && !diagnosis.isTentative) {
    printText("\nadd it:  naocal solve {} -o result.json\n", asked.commandLine(diagnosis.suggested));
  }
  printText("({:.2f} s)\n", diagnosis.seconds);
}

void printOwnEffectHint(bool isThere, const Diagnosis& diagnosis, const GivenOptions& asked, const std::string& file) {
  if (!isThere) {
    printText("no unexplained pattern was found that an expression fits, so {} was not written\n", file);
  } else if (file.empty()) {
    printText("{}:  naocal diagnose {} --own own.json\n",
              diagnosis.own ? "add it as a custom effect" : "try its expression as a custom effect",
              asked.commandLine());
  } else {
    const GivenOptions withIt{asked.sets, {}, {}, file, asked.samePlace, asked.skipBad};
    printText("{0} has its expression as a custom effect; see what it explains:  naocal diagnose {1}\n"
              "and calibrate with it:  naocal solve {1} -o result.json\n",
              file, withIt.commandLine());
  }
}

void printNextPoses(const NextPoses& next, GivenOptions asked, const std::string& file) {
  if (!next.whyNone.empty()) {
    if (!file.empty()) {
      printText("no poses are proposed, and {} is not written: {}\n", file, next.whyNone);
    }
    return;
  }
  if (next.poses.empty() || file.empty()) {
    printText("next poses (measuring them {}):  naocal diagnose {} --next poses.json\n", next.why, asked.commandLine());
    return;
  }
  asked.sets.emplace_back("FURTHER-SET");
  asked.samePlace = true;
  printText("\n{} holds {} poses. Measuring in them {}. {} {}, then:\n"
            "  naocal diagnose {}\n",
            file, next.poses.size(), next.why, whatTheyTell(next), howToTake(next), asked.commandLine());
}

} // namespace naocal
