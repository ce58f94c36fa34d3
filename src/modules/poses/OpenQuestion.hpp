#pragma once

#include "diagnose/Diagnosis.hpp"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace naocal {

/// An effect that may be there, and what is believed about it.
struct Suspect {
  std::string label;         // "elasticity@LKneePitch"
  Eigen::VectorXd size;      // of its unknowns if it is there [the unknowns' units]
  Eigen::VectorXd plausible; // how large they may be: their priors' sigmas
  double odds = 0;           // that it is the one, or is there at all; of all suspects together 1
};

/// What captures leave open, best answered by further poses.
struct OpenQuestion {
  std::vector<Suspect> suspects; // the likeliest first; none: nothing is open
  bool rivals = false;           // which one of the suspects is there? else: is each of them there at all?
  std::vector<std::string> with; // what the model has beyond the base: none of the suspects
  std::vector<std::string> without;
  std::vector<Effect> effects; // all that suspects and model are named by
  std::string why;             // "tells elasticity@LKneePitch from backlash@LKneePitch"; empty: there is no question
  std::string whyNone;         // in words, where there is no question that poses could answer
};

/// The first of these that a diagnosis leaves open: which effect of a class that its captures cannot tell apart is
/// there; whether a curve that no effect describes is what its best rival of the catalogue says; whether candidates are
/// there that the captures hardly test. Odds are exp(evidence / 2), evidence = 2 ln of the Bayes factor.
OpenQuestion openQuestion(const Diagnosis& diagnosis, const Robot& robot, const DiagnosisOptions& asked);

/// 2 ln Bayes factors as probabilities: exp(evidence / 2), together 1.
std::vector<double> probabilities(const std::vector<double>& evidence);

} // namespace naocal
