#pragma once

#include "judge/Case.hpp"

namespace blind {

/// What one answer is worth. Absent: the question does not arise there.
struct Marks {
  bool alarmed = false;                              // it says that something is wrong with the model or the captures
  bool unknownSaid = false;                          // it says that no known effect explains the misfit
  std::optional<bool> detected, top1, top3, inClass; // one hidden effect of the catalogue
  std::optional<double> expected;                    // probability of detection by theory
  std::vector<bool> covered;                         // by true unknown: inside the 95 % interval
  std::optional<bool> errorFell, nearFloor;          // on locked poses, by adding what was suggested
  std::optional<bool> bothFound;                     // two effects
  std::optional<int> extra;                          // suggested beyond them
  std::optional<bool> placeAndDriver;                // outside the catalogue
  std::optional<bool> saidUntestable, saidCorrupted;
  std::optional<bool> wronglyUsable, wronglyUsableAfter; // of results called usable: an offset beyond 3.5 of its sigmas
  std::vector<bool> offsetsInside, offsetsInsideAfter;   // by joint: the 95 % interval holds the truth
  std::optional<double> rmsRatio;                        // of the first fit, against one with the usual noise levels
  std::optional<bool> extraNamed;                  // something is suggested that is neither the effect nor its class
  std::optional<bool> blamedOnCaptures;            // an effect said to be bad captures or scatter
  std::optional<bool> eventNamed, eventTimed;      // what moved, and between which readings
  std::optional<bool> jitterAdequate, jitterLevel; // nothing is missing, and the level within a fifth
};

Marks markAnswer(const Case& one);

/// Whether a set of this group hides an effect of the catalogue, one alone.
bool hidesOne(const Truth& truth);

/// Probability that the largest of many tests, of which `candidates` were made and three quarters count as independent,
/// raises a 5 % alarm for an effect of this noncentrality and number of unknowns.
double theoreticalPower(double noncentrality, std::size_t unknowns, std::size_t candidates);

} // namespace blind
