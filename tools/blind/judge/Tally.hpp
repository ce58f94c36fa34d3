#pragma once

#include "judge/Marks.hpp"

#include <nlohmann/json_fwd.hpp>

namespace blind {

/// A proportion with its binomial 95 % interval (Clopper and Pearson).
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

/// Running mean.
struct Mean {
  double sum = 0;
  std::size_t all = 0;
  void add(double value) { sum += value, ++all; }
  double value() const { return all == 0 ? 0 : sum / static_cast<double>(all); }
};

/// Counts for one effect family, size, number of poses and noise regime, or pooled.
struct Cell {
  Share detected, top1, top3, inClass, covered, errorFell, nearFloor;
  Mean expected;
  void add(const Marks& one);
};

/// All counts of the benchmark.
struct Tally {
  std::map<std::string, Share> falseAlarms; // by noise regime; controls without effect
  Share decoyAlarms, falseUnknown, bothFound, saidUntestable, saidCorrupted;
  std::map<std::string, Share> byCorruption, untestableByKind;
  Share unknownClean, unknownSticking; // outside the catalogue: joint, driver and verdict correct
  std::map<std::string, Share> unknownByKind;
  Mean extra;
  std::map<double, Cell> bySize;                                           // by target noncentrality; 0: physical sizes
  std::map<std::string, Cell> byFamily;                                    // noncentrality 20 and more
  std::map<std::tuple<std::string, double, int, std::string>, Cell> cells; // family, size, poses, noise
  Cell pictures;                      // rendered sets, excluded from the sizes above
  std::map<double, Cell> byPlausible; // by plausible size: small, medium, large
  /// Offsets of many results.
  struct Offsets {
    Share inside;               // offsets within their 95 % interval
    Share beyond, usableBeyond; // results with an offset beyond its 99.95 % bound: all, and those called usable
    std::vector<double> widths; // of bounds over 7 sigma
    void add(const Marks::Offsets& marked);
  };
  Offsets sound, hidden, added;               // sound sets; hidden effects, as given and after adding what is suggested
  std::map<std::string, Share> insideByGroup; // offsets within their 95 % interval, results as given
  Share cameraBlamed, extraNamed, twinClass;
  std::vector<double> rmsRatios; // first fit relative to the default noise levels, large effects
  std::map<std::string, Share> eventNamed, eventTimed, jitterAdequate, jitterLevel; // by event, by repeat kind
  bool machines = false;                              // robots with a URDF: their own figures
  std::map<std::string, Share> misfitSaid;            // controls of machines, by how they are measured
  std::map<std::string, Share> culpritNamed;          // wrong set-ups and bad readings, by kind
  std::map<std::string, Cell> byWitness;              // noncentrality 40 and more, by how they are measured
  std::map<std::string, std::vector<double>> pValues; // of solve, by noise regime; sound sets
  Mean seconds;
  std::size_t sets = 0, withoutVerdict = 0;
};

/// Marks all cases and counts.
Tally tallyCases(const std::vector<Case>& cases);

/// EVALUATION.json (`naocal-effect-evaluation`).
nlohmann::json evaluationJson(const Tally& tally);

/// A figure with its required value.
struct Required {
  std::string what, wanted;
  Share share;
  bool met = false;
  std::optional<double> value = std::nullopt; // for non-proportions; `share.all` is then the sample size
};
/// All figures that the benchmark must reach, and whether each is met.
std::vector<Required> requiredFigures(const Tally& tally);

} // namespace blind
