#pragma once

#include "diagnosis/evidence/CandidateTests.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// What one pose says about a candidate, both in standard errors of one number.
struct AddedVariablePoint {
  std::optional<std::size_t> pose; // absent: what was believed of the model's own unknowns before
  double signature = 0;            // how far one unit of the candidate moves the pose's pictures
  double residual = 0;             // how far they were measured to have moved that way
};

/// A candidate's added-variable plot, reduced to one point per pose (Cook and Weisberg 1982):
///
///   e = M g~ of the pose, signature = |e|, residual = -e . M r~ / |e|,
///   slope = sum(signature * residual) / sum(signature^2),  sigma = sum(signature^2)^-1/2
///
/// where M takes off what the model's own unknowns can follow. The slope over all points is the candidate's estimate.
/// A point stands left of zero where e moves the pose against the sense of `like`.
struct AddedVariable {
  std::vector<AddedVariablePoint> points;
  double slope = 0, sigma = 0; // [the unknown's unit]; of several unknowns: in units of their estimates together
  std::string like;            // the model's own effect that imitates the candidate best
};

/// Of a candidate effect; absent where the model absorbs it.
std::optional<AddedVariable> computeAddedVariable(const CandidateTests& inquiry, const Model& model,
                                                  std::size_t candidate);

/// A candidate as one column beside the model's own unknowns, in sums whitened at one level of noise, and what the own
/// unknowns can do about it.
struct CandidateColumn {
  /// `direction`: by how much each of the candidate's unknowns moves with the column [the unknown's unit].
  CandidateColumn(const CandidateTests& inquiry, std::size_t candidate, const Eigen::VectorXd& direction,
                  const Noise& noise);

  struct Pose {
    std::vector<Eigen::Index> columns; // the own unknowns that it depends on, then the candidate (numbered `own`)
    Eigen::MatrixXd information;       // J^T Sigma^-1 J
    Eigen::VectorXd gradient;          // J^T Sigma^-1 r
  };
  std::vector<Pose> poses;
  Eigen::VectorXd prior;     // information of the own unknowns before
  Eigen::VectorXd imitation; // the own unknowns that follow one unit of the column best
  Eigen::VectorXd fitted;    // the own unknowns' step to the minimum, the column left out
  Eigen::Index like = 0;     // the own unknown that alone follows it best
};

/// The label of the term that an unknown of the model belongs to.
std::string termLabel(const Model& model, Eigen::Index unknown);

} // namespace naocal
