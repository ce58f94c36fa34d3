#pragma once

#include "residuals/PictureGram.hpp"
#include "residuals/Residuals.hpp"

namespace naocal {

/// What a picture needs: quantities (the angles on its paths first) and the unknowns that move them.
struct Residuals::Prepared {
  struct Entry {
    std::size_t quantity, unknown;
    Eigen::Index slot, local; // place among the picture's quantities, and among its pose's unknowns
    double value;
  };
  std::vector<std::size_t> links;
  std::vector<std::size_t> quantities;
  std::vector<std::size_t> joints; // of the first quantities
  std::vector<Entry> entries;
  std::vector<std::vector<std::size_t>> extras; // per sighting
};

struct Residuals::Workspace {
  Posture torsoFromLink;
  ProjectedBlocks projected;
  std::vector<Lane, Eigen::aligned_allocator<Lane>> extraRows;
  PictureGram sums;
  Eigen::MatrixXd columns, gram;
  Eigen::VectorXd gradient;
  double cost = 0; // sum of rho
};

} // namespace naocal
