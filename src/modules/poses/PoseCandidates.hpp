#pragma once

#include "poses/PoseOptions.hpp"
#include "poses/RandomAttitude.hpp"
#include "residuals/Noise.hpp"

#include <functional>
#include <vector>

namespace naocal {

/// Valid poses, and how many attitudes it took.
struct PoseCandidates {
  std::vector<SievedPose> attitudes;
  Sieve sieve;
};

/// Sieves `options.tries` attitudes on all cores. The same options give the same candidates on any number of cores.
/// `progress` is told how many were tried, now and then, by one thread at a time.
PoseCandidates poseCandidates(const Robot& robot, const Scene& scene, const PoseOptions& options,
                              const std::function<void(std::size_t)>& progress = {});

/// What each pose tells about the scene's unknowns (Scene::information), one picture of each camera: pixel noise, and
/// each joint's encoder error and scatter, which moves all corners of a pose together, integrated out.
std::vector<Eigen::MatrixXd> informations(const Robot& robot, const Scene& scene, const std::vector<SievedPose>& poses,
                                          const Noise& noise);

} // namespace naocal
