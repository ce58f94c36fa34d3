#include "judge/Tally.hpp"

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
  figures.atLeast("two effects at once: both classes", 90, tally.bothFound);
  if (tally.extra.all > 0) {
    figures.add(fmt::format("extra suggestions per pair: {:.2f}", tally.extra.value()), "at most 0.05",
                {0, tally.extra.all}, tally.extra.value() <= 0.05);
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
  return std::move(figures).all();
}

} // namespace blind
