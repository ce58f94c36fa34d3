#include "judge/MachineFigures.hpp"

#include "judge/Figures.hpp"

#include <fmt/format.h>

namespace blind {

std::vector<Required> machineFigures(const Tally& tally) {
  Figures figures;
  Share alarms;
  for (const auto& [witness, share] : tally.falseAlarms) {
    figures.atMost("false alarms on controls, " + witness, 7, share);
    alarms.yes += share.yes;
    alarms.all += share.all;
  }
  figures.atMost("false alarms on controls, all", 7, alarms);
  for (const auto& [witness, share] : tally.misfitSaid) {
    figures.atMost("said not to fit without a cause, controls, " + witness, 7, share);
  }
  addPower(tally, figures);
  for (const auto& [size, percent] : {std::pair{20.0, 85.0}, {40.0, 95.0}, {80.0, 98.0}}) {
    figures.atLeast(fmt::format("right class at noncentrality {:g}", size), percent, cellAt(tally, size).inClass);
  }
  for (const auto& [size, percent] : {std::pair{20.0, 90.0}, {40.0, 97.0}}) {
    figures.atLeast(fmt::format("among the first three at {:g}", size), percent, cellAt(tally, size).top3);
  }
  for (const auto& [witness, cell] : tally.byWitness) {
    figures.atLeast("right class at noncentrality 40 and 80, " + witness, 95, cell.inClass);
  }
  figures.between("95 % interval of the size covers the truth", 90, 98, poolSizes(tally).covered);
  addOffsets(tally, figures);
  figures.atMost("extra suggestions, neither truth nor class, one effect", 3, tally.extraNamed);
  for (const auto& [kind, share] : tally.culpritNamed) {
    figures.atLeast(kind + ": named", 95, share);
  }
  for (const auto& [what, share] : tally.eventNamed) {
    figures.atLeast(what + ": named", 97, share);
    figures.atLeast(what + ": named and timed", 97, tally.eventTimed.at(what));
  }
  addUniformity(tally, figures);
  return std::move(figures).all();
}

} // namespace blind
