#include "judge/Tally.hpp"
#include "judge/Uniformity.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace blind {

namespace {

Cell cellAt(const Tally& tally, double size) {
  const auto found = tally.bySize.find(size);
  return found == tally.bySize.end() ? Cell{} : found->second;
}

class Figures {
public:
  void atLeast(std::string what, double percent, const Share& share) {
    add(std::move(what), fmt::format("at least {:g} %", percent), share, share.rate() >= percent / 100);
  }
  void atMost(std::string what, double percent, const Share& share) {
    add(std::move(what), fmt::format("at most {:g} %", percent), share, share.rate() <= percent / 100);
  }
  /// Of offsets, which of one set are not independent: the band is too narrow by little.
  void coverage(std::string what, const Share& share) {
    add(std::move(what), "93 to 97 %", share, share.rate() >= 0.93 && share.rate() <= 0.97);
  }
  void value(std::string what, std::string wanted, double value, std::size_t sets, bool met) {
    if (sets > 0) {
      figures_.push_back({std::move(what), std::move(wanted), {0, sets}, met, value});
    }
  }
  void add(std::string what, std::string wanted, const Share& share, bool met) {
    if (share.all > 0) {
      figures_.push_back({std::move(what), std::move(wanted), share, met});
    }
  }
  std::vector<Required> all() && { return std::move(figures_); }

private:
  std::vector<Required> figures_;
};

} // namespace

namespace {

/// What must hold where the model is wrong or the readings are: of results, causes and events.
void addHonesty(const Tally& tally, Figures& figures) {
  figures.atMost("called usable with an offset beyond 3.5 sigma, effect hidden", 2, tally.wronglyUsable);
  figures.atMost("... after adding what is suggested", 2, tally.wronglyUsableAfter);
  figures.coverage("offsets inside their 95 % interval, sound sets", tally.offsetsSound);
  figures.coverage("... effect hidden, nothing added", tally.offsetsHidden);
  figures.coverage("... effect hidden, what is suggested added", tally.offsetsAfter);
  const std::size_t large = tally.rmsRatios.size();
  if (large > 0) {
    const double middle = median(tally.rmsRatios);
    const double worst = *std::max_element(tally.rmsRatios.begin(), tally.rmsRatios.end());
    figures.value("rms of the first fit against --fixed-noise, large, median", "at most 1.1", middle, large,
                  middle <= 1.1);
    figures.value("... worst", "at most 1.5", worst, large, worst <= 1.5);
  }
  for (const auto& [size, percent] : {std::pair{0.5, 92.0}, {1.0, 95.0}, {2.0, 97.0}}) {
    const auto cell = tally.byPlausible.find(size);
    if (cell != tally.byPlausible.end()) {
      figures.atLeast(fmt::format("truth or its class first at {:g} plausible sizes", size), percent,
                      cell->second.inClass);
    }
  }
  figures.atLeast("truth or its class first where a twin imitates it", 92, tally.twinClass);
  figures.atMost("extra suggestions, neither truth nor class, one effect", 3, tally.extraNamed);
  figures.atMost("cameras' and lenses' errors said to be bad captures or scatter", 1, tally.cameraBlamed);
  for (const auto& [what, share] : tally.eventNamed) {
    figures.atLeast(what + ": named", 97, share);
    figures.atLeast(what + ": named and timed", 97, tally.eventTimed.at(what));
  }
  for (const auto& [repeats, share] : tally.jitterAdequate) {
    figures.atLeast("jitter of readings, " + repeats + ": adequate", 95, share);
    figures.atLeast("jitter of readings, " + repeats + ": level within 20 %", 95, tally.jitterLevel.at(repeats));
  }
  for (const auto& [regime, numbers] : tally.pValues) {
    if (numbers.size() < fewestForUniformity) { // no test of so few can fail
      continue;
    }
    const double p = uniformityP(numbers);
    figures.value("solve's p on sound sets uniform (KS), " + regime, "p above 0.01", p, numbers.size(), p > 0.01);
  }
}

} // namespace

std::vector<Required> requiredFigures(const Tally& tally) {
  Figures figures;
  for (const auto& [regime, share] : tally.falseAlarms) {
    figures.atMost("false alarms on controls, " + regime, 7, share);
  }
  for (const double size : {10.0, 20.0, 40.0}) {
    const Cell cell = cellAt(tally, size);
    const double theory = cell.expected.value();
    figures.add(fmt::format("detected at noncentrality {:g}", size), fmt::format("{:.0f} % ± 10", 100 * theory),
                cell.detected, cell.detected.rate() >= theory - 0.1);
  }
  for (const auto& [size, percent] : {std::pair{20.0, 85.0}, {40.0, 95.0}, {100.0, 98.0}}) {
    figures.atLeast(fmt::format("right class at noncentrality {:g}", size), percent, cellAt(tally, size).inClass);
  }
  for (const auto& [size, percent] : {std::pair{20.0, 90.0}, {40.0, 97.0}}) {
    figures.atLeast(fmt::format("among the first three at {:g}", size), percent, cellAt(tally, size).top3);
  }
  figures.atLeast("two effects at once: each suggested or told to be trivial", 90, tally.bothFound);
  if (tally.extra.all > 0) {
    figures.value("extra suggestions per pair", "at most 0.05", tally.extra.value(), tally.extra.all,
                  tally.extra.value() <= 0.05);
  }
  figures.atLeast("outside the catalogue, 0.3°, clean: joint, driver, \"unknown\"", 90, tally.unknownClean);
  figures.atLeast("outside the catalogue, stiction, noncentrality 40 and 80", 90, tally.unknownSticking);
  figures.atMost("\"unknown\" on controls and catalogued effects", 5, tally.falseUnknown);
  Share fell, near, covered;
  for (const auto& [size, cell] : tally.bySize) {
    for (const auto& [sum, part] :
         {std::pair{&fell, &cell.errorFell}, {&near, &cell.nearFloor}, {&covered, &cell.covered}}) {
      sum->yes += part->yes;
      sum->all += part->all;
    }
  }
  figures.atLeast("the suggestion lowers the error on locked poses", 95, fell);
  figures.atLeast("... to within 10 % of the floor", 95, near);
  figures.add("95 % interval of the size covers the truth", "90 to 98 %", covered,
              covered.rate() >= 0.90 && covered.rate() <= 0.98);
  figures.atLeast("absorbed effects said to be untestable", 95, tally.saidUntestable);
  figures.atLeast("corrupted sets said to be corrupted", 95, tally.saidCorrupted);
  addHonesty(tally, figures);
  return std::move(figures).all();
}

} // namespace blind
