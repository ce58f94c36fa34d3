#pragma once

#include "poses/OpenQuestion.hpp"
#include "poses/PlannedCaptures.hpp"
#include "residuals/Residuals.hpp"

#include <vector>

namespace naocal {

/// A pose's information about the unknowns that it depends on, its joints' deflections eliminated.
struct PoseInformation {
  std::vector<std::size_t> unknowns;
  Eigen::MatrixXd hessian;

  void addTo(Eigen::MatrixXd& sum) const;
};

/// `samples`: pictures taken without moving, that is, with the same encoder errors.
PoseInformation informationOf(PoseSystem pose, const Noise& noise, double samples = 1);

/// A model that was fitted to captures.
struct FittedModel {
  const Model& model;
  const Eigen::VectorXd& unknowns;
  Noise noise;
};

/// What captures tell about the unknowns, and what planned ones would.
struct PlannedInformation {
  Model own;                             // the question's model for all of them; the suspects' unknowns come behind
  Eigen::MatrixXd known;                 // priors and captures
  std::vector<PoseInformation> promised; // per planned pose
};

/// The measurement model linearised at the fit, for captures and planned poses (withPlanned); suspects absent.
PlannedInformation plannedInformation(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                                      const FittedModel& fit, const OpenQuestion& question,
                                      const std::vector<Surroundings>& around, const std::vector<ProposedPose>& poses,
                                      bool samePlace);

/// Pictures per pose and camera.
double samplesOf(const Measurements& measurements);

/// The model with the suspects behind its own unknowns.
Model withSuspects(const Measurements& measurements, const Model& model, const OpenQuestion& question);

} // namespace naocal
