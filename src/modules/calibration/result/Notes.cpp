#include "calibration/result/Notes.hpp"

#include "calibration/BoardMoves.hpp"
#include "calibration/result/Assumptions.hpp"
#include "calibration/result/Wording.hpp"
#include "io/Units.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <utility>

namespace naocal {

namespace {

using Findings = std::vector<Finding>;

/// Offsets that other terms imitate. The result stays usable: beside placements, which nothing holds, they stay at
/// zero; with other effects, as large as is plausible of each, they share what the captures tell.
void addHeldOffsets(const FittedModel& fitted, const HeldOffsets& held, Findings& notes) {
  for (const Term& term : fitted.model.terms()) {
    if (const auto found = held.find(term.first); found != held.end()) {
      notes.push_back(makeFinding(
          "weak", term.label(), FindingLevel::note,
          fmt::format("{} cannot be told from {}{} (±{})", describeUnknown(term, 0), describeImitator(*found->second),
                      found->second->isPlacement ? " and is held at zero" : "; only what both do together is known",
                      formatSigma(term, fitted.fit.estimates[term.first].bestSigma())),
          fitted.measurements));
    }
  }
}

/// Doubtful measurements of one kind: "corner", "reading".
void addDoubtful(std::size_t count, const std::string& kind, const Measurements& measurements, Findings& notes) {
  if (count > 0) {
    const bool single = count == 1;
    notes.push_back(makeFinding("accident", kind + "s", FindingLevel::note,
                                fmt::format("{} {}{} {} not fit the rest and got little or no weight", count, kind,
                                            single ? "" : "s", single ? "does" : "do"),
                                measurements));
  }
}

void addOutliers(const FittedModel& fitted, Findings& notes) {
  std::size_t corners = 0;
  for (const Outlier& outlier : fitted.fit.outliers) {
    corners += outlier.corners.size();
  }
  addDoubtful(fitted.fit.doubtfulReadings.size(), "reading", fitted.measurements, notes);
  addDoubtful(corners, "corner", fitted.measurements, notes);
}

/// Measurements that lie far from the likeliest explanation and share something.
void addSharedCause(const FittedModel& fitted, Findings& notes) {
  if (!fitted.fit.sharedCauses.empty()) {
    const SharedCause& first = fitted.fit.sharedCauses.front();
    notes.push_back(makeFinding(
        "unknown-effect", first.driver, FindingLevel::act,
        fmt::format(
            "the measurements that fit worst share {} (p = {:.1g}): they are no accidents, and keep their weight",
            first.driver, first.p),
        fitted.measurements));
    notes.back().numbers = {{"p", first.p}};
  }
}

/// Boards that were displaced in single pictures.
void addDisplacedBoards(const FittedModel& fitted, Findings& notes) {
  for (const Outlier& outlier : fitted.fit.outliers) {
    if (outlier.move) {
      const ImageObservation& picture = fitted.measurements.pictures[outlier.picture];
      const Capture& capture = fitted.measurements.captureOf(picture);
      const std::string& board =
          fitted.measurements.targets[picture.observations[outlier.observation].view.board()].name;
      notes.push_back(makeFinding(
          "accident", fmt::format("capture-{}@{}", nameCapture(fitted.measurements, picture.set, capture.id), board),
          FindingLevel::note, describeDisplacedBoard(fitted.measurements, outlier) + ": left out there",
          fitted.measurements));
      notes.back().where.captures = {capture.id};
      notes.back().where.poses = {capture.pose};
      notes.back().numbers = {{"metres", outlier.move->distance()}};
    }
  }
}

/// Unlikely explanations that would move an estimate far, those first whose bound is widest beside the interval.
void addShoulders(const FittedModel& fitted, Findings& notes) {
  std::vector<std::pair<double, Finding>> far;
  for (const Term& term : fitted.model.terms()) {
    for (std::size_t i = 0; i < term.effect.unknowns.size() && !term.isPlacement && term.requested; ++i) {
      const Unknown& unknown = term.effect.unknowns[i];
      const auto& averaged = fitted.fit.estimates[term.first + i].averaged;
      if (averaged && averaged->shoulder) {
        Finding finding =
            makeFinding("weak", fmt::format("bound:{}.{}", term.label(), unknown.name), FindingLevel::note,
                        formatShoulder(nameUnknown(term, i), unknown.unit, *averaged), fitted.measurements);
        finding.numbers = {{"low", averaged->bound[0]}, {"high", averaged->bound[1]}};
        far.emplace_back((averaged->bound[1] - averaged->bound[0]) / (averaged->interval[1] - averaged->interval[0]),
                         std::move(finding));
      }
    }
  }
  std::stable_sort(far.begin(), far.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::transform(far.begin(), far.end(), std::back_inserter(notes), [](auto& one) { return std::move(one.second); });
}

/// Directions that the captures hardly tell.
void addWeakDirections(const FittedModel& fitted, Findings& notes) {
  for (std::size_t i = 0; i < fitted.fit.weak.size(); ++i) {
    const WeakDirection& weak = fitted.fit.weak[i];
    const std::string size =
        weak.unit == "rad" ? fmt::format("± {:.2g}° along this combination", degrees(weak.sigma))
                           : fmt::format("{:.0f} % of the prior uncertainty remains", 100 * std::min(1.0, weak.sigma));
    notes.push_back(makeFinding("weak", fmt::format("direction:{}", i + 1), FindingLevel::note,
                                fmt::format("{} ({})", weak.sentence, size), fitted.measurements));
    std::string places;
    for (const auto& [name, share] : weak.parts) { // "jointOffset@HeadYaw.o"
      const std::size_t at = name.find('@') + 1;
      places += (places.empty() ? "@" : ",") + name.substr(at, name.rfind('.') - at);
    }
    notes.back().where = placeOf(places, fitted.measurements);
    notes.back().numbers = {{"sigma", weak.sigma}};
  }
}

/// The worst bias that the captures might not show.
void addUndetectable(const FittedModel& fitted, Findings& notes) {
  if (const auto& worst = fitted.fit.undetectable) {
    notes.push_back(
        makeFinding("weak", worst->effect, FindingLevel::note,
                    fmt::format("{} can shift the {} by {}, and these captures might not show it", worst->effect,
                                worst->of == "task" ? fitted.fit.task->what : "offset of " + worst->of,
                                formatSize(worst->bias, worst->unit)),
                    fitted.measurements));
    notes.back().numbers = {{"bias", worst->bias}};
  }
}

} // namespace

std::vector<Finding> listNotes(const FittedModel& fitted, const HeldOffsets& held) {
  std::vector<Finding> notes;
  addOutliers(fitted, notes);
  addSharedCause(fitted, notes);
  addDisplacedBoards(fitted, notes);
  append(listAssumptions(fitted.measurements, fitted.model.terms()), notes);
  addHeldOffsets(fitted, held, notes);
  addShoulders(fitted, notes);
  addWeakDirections(fitted, notes);
  addUndetectable(fitted, notes);
  return notes;
}

} // namespace naocal
