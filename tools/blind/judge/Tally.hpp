#pragma once

#include "judge/Marks.hpp"

#include <nlohmann/json_fwd.hpp>

namespace blind {

/// How often something was so, with the binomial's 95 % interval (Clopper and Pearson).
struct Share {
  std::size_t yes = 0, all = 0;
  void add(bool is) { yes += is, ++all; }
  void add(const std::optional<bool>& is) {
    if (is) {
      add(*is);
    }
  }
  double rate() const { return all == 0 ? 0 : static_cast<double>(yes) / static_cast<double>(all); }
  double low() const;
  double high() const;
};

/// Mean of numbers.
struct Mean {
  double sum = 0;
  std::size_t all = 0;
  void add(double value) { sum += value, ++all; }
  double value() const { return all == 0 ? 0 : sum / static_cast<double>(all); }
};

/// One family at one size, number of poses and regime of noise, or many of them pooled.
struct Cell {
  Share detected, top1, top3, inClass, covered, errorFell, nearFloor;
  Mean expected;
  void add(const Marks& one);
};

/// Everything that the benchmark counts.
struct Tally {
  std::map<std::string, Share> falseAlarms; // by regime of noise; controls without effect
  Share decoyAlarms, falseUnknown, bothFound, saidUntestable, saidCorrupted;
  std::map<std::string, Share> byCorruption, untestableByKind;
  Share unknownClean, unknownSticking; // outside the catalogue: joint, driver and verdict right
  std::map<std::string, Share> unknownByKind;
  Mean extra;
  std::map<double, Cell> bySize;                                           // noncentrality aimed at; 0: physical sizes
  std::map<std::string, Cell> byFamily;                                    // at noncentrality 20 and more
  std::map<std::tuple<std::string, double, int, std::string>, Cell> cells; // family, size, poses, noise
  Cell pictures;                                   // rendered sets, which the sizes above leave out
  std::map<double, Cell> byPlausible;              // small, medium, large, in plausible sizes
  Share wronglyUsable, wronglyUsableAfter;         // results called usable, hidden effects
  Share offsetsSound, offsetsHidden, offsetsAfter; // inside their interval; sound sets, hidden effects, what is
                                                   // suggested added
  Share cameraBlamed, extraNamed, twinClass;
  std::vector<double> rmsRatios; // of the first fit against one with the usual noise, large effects
  std::map<std::string, Share> eventNamed, eventTimed, jitterAdequate, jitterLevel; // by what happens, by repeats
  std::map<std::string, std::vector<double>> pValues; // of solve, by regime of noise; sound sets
  Mean seconds;
  std::size_t sets = 0, withoutVerdict = 0;
};

Tally tallyCases(const std::vector<Case>& cases);

/// EVALUATION.json (`naocal-effect-evaluation`).
nlohmann::json evaluationJson(const Tally& tally);

/// A figure that the benchmark must show.
struct Required {
  std::string what, wanted;
  Share share;
  bool met = false;
  std::optional<double> value = std::nullopt; // where it is no share: then `share.all` counts what it is of
};
std::vector<Required> requiredFigures(const Tally& tally);

} // namespace blind
