#pragma once

#include "estimation/EffectJacobian.hpp"
#include "estimation/NormalEquations.hpp"
#include "measurements/Measurements.hpp"

#include <Eigen/Core>
#include <vector>

namespace naocal {

/// Buffers of the evaluation of pictures, one set per thread: allocating them takes as long as projecting the corners.
struct PictureWorkspace {
  /// This thread's, for the first picture of a pose.
  static PictureWorkspace& ofThread(const Measurements& measurements);

  /// Cached, since most boards keep their placement from picture to picture.
  const RigidTransform& linkFromBoard(std::size_t board);
  /// Drivers at the picture's instant, into `scratch.driven`. Cached, since pictures of one reading share angles,
  /// torques and centre of mass.
  void drive(const Measurements& measurements, const Model& model, const ImageObservation& picture,
             const Eigen::VectorXd& unknowns);
  /// Adds a group's sums to those of its pose.
  void add(const ImageNormalEquations::Square& gram, const ImageNormalEquations::Column& gradient,
           const Eigen::MatrixXd& by, const PreparedImage::Group& group);

  struct PlacedBoard {
    Eigen::Matrix<double, 6, 1> placement = Eigen::Matrix<double, 6, 1>::Zero();
    RigidTransform linkFromBoard;
  };

  ModelState modelState{StateLayout{0, 0, 0}};
  std::vector<PlacedBoard> boards;
  LinkPoses torsoFromLink;
  ProjectedBlocks projected;
  std::vector<CornerShift> extraShifts;
  ImageNormalEquations corners;
  Eigen::MatrixXd motion;
  NormalEquations sums; // of a pose, or
  RowEquations rows;    // of a pose
  bool wantsRows = false;
  double cost = 0;                                 // sum of rho
  const ImageObservation* drivenPicture = nullptr; // the picture that `scratch.driven` belongs to
  EffectJacobian::Scratch scratch;
  std::vector<double> varyingSlopes;
  const double* slopes = nullptr; // slope values of the picture
};

} // namespace naocal
