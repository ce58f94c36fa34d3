#pragma once

#include "diagnose/Inquiry.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// A candidate as one column beside the model's own unknowns, in sums whitened at one level of noise, and what the own
/// unknowns can do about it.
struct CandidateColumn {
  /// `direction`: by how much each of the candidate's unknowns moves with the column [the unknown's unit].
  CandidateColumn(const Inquiry& inquiry, std::size_t candidate, const Eigen::VectorXd& direction, const Noise& noise);

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
std::string labelOf(const Model& model, Eigen::Index unknown);

} // namespace naocal
