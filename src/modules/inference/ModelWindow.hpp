#pragma once

#include "inference/WideModel.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace naocal {

/// A group of columns in a model: all of an effect's, or of a curve as many as its degree needs.
struct WindowMember {
  std::size_t group = 0;
  Eigen::Index count = 0;
};

/// One explanation of the captures: the model's own unknowns and these effects and curves, each about as large as
/// plausible or beyond.
struct WindowModel {
  std::vector<WindowMember> members;
  std::vector<double> widths; // of each member's prior, in units of what is plausible (`plausibleWidths`)
  double cost = 0;            // -2 ln of its posterior probability, up to a constant: 0 for the model alone
  double weight = 0;          // its share among the window's models
  double chi2 = 0;            // from pose to pose: beyond what is left when every joint may deflect anew in every pose
  double freedom = 0;
  Eigen::VectorXd unknowns;  // the own ones, its members refitted
  Eigen::VectorXd variances; // of these
  Eigen::VectorXd sizes;     // of its members' columns, one after the other [the columns' units]
};

/// What the captures say of the own unknowns if this or that may be missing: an average over a window of models.
///
/// The cost of a model m, D_m = -2 ln B_m + 2 ln K per effect (K: effects to choose from; for a curve: curves, times
/// four degrees) with B_m as in `computeBayesFactor`, but a width of its own for each member: where one number of an
/// effect is beyond plausible, another one that the captures do not tell may be, too. Each choice of widths is a model.
/// From the model alone, the group that lowers D most is added until none does, then what does not raise D by its
/// removal is dropped (a twin leaves when the truth joins). The window is that model, every removal, every swap of one
/// member, and every addition (Madigan and Raftery, JASA 89 (1994) 1535; Hoeting et al., Statistical Science 14 (1999)
/// 382), weighted by exp(-D_m / (2 misfit)) (quasi-likelihood: Burnham and Anderson, Model selection, 2002, section
/// 2.5):
///   mean = sum w_m unknowns_m,   variance = sum w_m [misfit C_m + (unknowns_m - mean)^2].
/// Of `expected` effects it is known that they are there, but not which they are: they cost no 2 ln K.
struct ModelWindow {
  std::vector<WindowModel> models;  // likeliest first; those with a weight worth the name
  double misfit = 1;                // chi2 / freedom of the likeliest where above 1: what no model explains
  double freedom = 0;               // that of the likeliest
  Eigen::VectorXd mean, variance;   // of the own unknowns
  std::vector<double> groupWeights; // per group of the problem: of the models that have it

  /// The 95 % interval of an own unknown's posterior, a mixture of Student's t about each model's value: [low, high].
  std::array<double, 2> interval(Eigen::Index unknown) const;
};
ModelWindow searchModelWindow(const WideModel& wide, const Noise& noise, std::size_t expected = 0);

} // namespace naocal
