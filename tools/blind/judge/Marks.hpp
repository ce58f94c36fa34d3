#pragma once

#include "judge/Case.hpp"

namespace blind {

/// Assessment of one answer. Absent: not applicable.
struct Marks {
  bool alarmed = false;                              // reports an error of the model or the captures
  bool unknownSaid = false;                          // reports a misfit that no known effect explains
  bool misfitSaid = false;                           // reports a misfit without a cause
  std::optional<bool> detected, top1, top3, inClass; // one hidden effect of the catalogue
  std::optional<double> expected;                    // theoretical probability of detection
  std::vector<bool> covered;                         // per true unknown: inside the 95 % interval
  std::optional<bool> errorFell, nearFloor;          // on locked poses, after adding the suggestion
  std::optional<bool> bothFound;                     // two hidden effects
  std::optional<int> extra;                          // suggestions beyond them
  std::optional<bool> placeAndDriver;                // hidden effect outside the catalogue
  std::optional<bool> saidUntestable, saidCorrupted;
  /// Offsets that the captures tell, of a result as given and after adding what is suggested.
  struct Offsets {
    std::vector<bool> inside;         // per joint: the 95 % interval contains the truth
    std::optional<bool> beyond;       // a truth lies beyond its 99.95 % bound
    std::optional<bool> usableBeyond; // the same of a result called usable
    std::vector<double> widths;       // per joint: width of the bound over 7 sigma
  };
  Offsets given, added;
  std::optional<double> rmsRatio;                  // first fit relative to one with the default noise levels
  std::optional<bool> extraNamed;                  // a suggestion is neither the effect nor in its class
  std::optional<bool> blamedOnCaptures;            // an effect reported as bad captures or scatter
  std::optional<bool> eventNamed, eventTimed;      // the event is identified, and its time
  std::optional<bool> culpritNamed;                // the wrong set-up, or the bad reading and no effect
  std::optional<bool> jitterAdequate, jitterLevel; // no effect missing, and the level within 20 %
};

/// Compares an answer with the truth.
Marks markAnswer(const Case& one);

/// Whether sets of this group hide exactly one effect of the catalogue.
bool hidesOne(const Truth& truth);

/// Probability that the maximum of many tests (`candidates`, three quarters of them independent) raises a 5 % alarm for
/// an effect of this noncentrality and number of unknowns.
double theoreticalPower(double noncentrality, std::size_t unknowns, std::size_t candidates);

} // namespace blind
