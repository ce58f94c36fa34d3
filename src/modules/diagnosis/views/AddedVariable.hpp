#pragma once

#include "calibration/CandidateTests.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// One pose's contribution to a candidate's estimate, in standard errors of a single measurement.
struct AddedVariablePoint {
  std::optional<std::size_t> pose; // absent: the prior of the model's own unknowns
  double signature = 0;            // displacement of the pose's pictures by one unit of the candidate
  double residual = 0;             // measured displacement in that direction
};

/// Added-variable plot of a candidate, one point per pose (Cook and Weisberg 1982):
///
///   e = M g~ of the pose, signature = |e|, residual = -e . M r~ / |e|,
///   slope = sum(signature * residual) / sum(signature^2),  sigma = sum(signature^2)^-1/2
///
/// where M projects out the model's own unknowns. The slope over all points is the candidate's estimate. A point lies
/// left of zero if e moves the pose in the opposite direction to `like`.
struct AddedVariable {
  std::vector<AddedVariablePoint> points;
  double slope = 0, sigma = 0; // [the unknown's unit]; for several unknowns: in units of their joint estimate
  std::string like;            // label of the model's effect that mimics the candidate best; empty without any
};

/// Absent if the model absorbs the candidate.
std::optional<AddedVariable> computeAddedVariable(const CandidateTests& candidateTests, const Model& model,
                                                  std::size_t candidate);

/// A candidate as a single column beside the model's own unknowns, in sums whitened at one noise level, with the
/// response of the own unknowns.
struct CandidateColumn {
  /// `direction`: change of each of the candidate's unknowns per unit of the column [the unknown's unit].
  CandidateColumn(const CandidateTests& candidateTests, std::size_t candidate, const Eigen::VectorXd& direction,
                  const Noise& noise);

  struct Pose {
    std::vector<Eigen::Index> columns; // own unknowns that the pose depends on, then the candidate (index `own`)
    Eigen::MatrixXd information;       // J^T Sigma^-1 J
    Eigen::VectorXd gradient;          // J^T Sigma^-1 r
  };
  std::vector<Pose> poses;
  Eigen::VectorXd prior;     // prior information of the own unknowns
  Eigen::VectorXd imitation; // step of the own unknowns that mimics one unit of the column best
  Eigen::VectorXd fitted;    // step of the own unknowns to the minimum without the column
  Eigen::Index like = 0;     // index of the single own unknown that mimics it best
};

/// Label of the term that contains an unknown of the model.
std::string termLabel(const Model& model, Eigen::Index unknown);

} // namespace naocal
