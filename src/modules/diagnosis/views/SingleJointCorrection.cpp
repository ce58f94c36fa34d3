#include "diagnosis/views/SingleJointCorrection.hpp"

#include "math/LinearAlgebra.hpp"

#include <cmath>

namespace naocal {

namespace {

/// Pictures of a pose that one of its deflections affects.
std::vector<std::size_t> findBentPictures(const PoseGroup& pose, std::size_t motor, std::size_t error) {
  std::vector<std::size_t> result;
  for (const EncoderSample& reading : pose.readings) {
    if (reading.encoderError[motor] == error) {
      result.insert(result.end(), reading.pictures.begin(), reading.pictures.end());
    }
  }
  return result;
}

} // namespace

std::vector<SingleJointCorrection> computeJointCorrections(const Measurements& measurements,
                                                           const CandidateTests& candidateTests) {
  return computeJointCorrections(measurements, candidateTests.poses(), candidateTests.noise());
}

std::vector<SingleJointCorrection> computeJointCorrections(const Measurements& measurements,
                                                           const std::vector<PoseRows>& poses, Noise noise) {
  noise.pose = 0; // no pose noise: keeps pose-to-pose scatter visible
  std::vector<SingleJointCorrection> result;
  for (std::size_t motor : measurements.joints) {
    result.push_back({motor, {}});
  }
  for (std::size_t index = 0; index < measurements.poses.size(); ++index) {
    PoseRows rows = poses[index];
    rows.byUnknowns = rows.byDeflections; // deflections as unknowns
    const PoseSystem pose = systemOf(rows);
    const MarginalSystem whitened = marginalize(pose, noise, jointErrorRoot(pose, noise));
    for (std::size_t i = 0; i < pose.joints.size(); ++i) {
      const double information = whitened.hessian(eigenIndex(i), eigenIndex(i));
      if (!(information > 0)) {
        continue; // joint not observed
      }
      for (SingleJointCorrection& joint : result) {
        if (joint.motor == pose.joints[i]) {
          joint.points.push_back({findBentPictures(measurements.poses[index], pose.joints[i], pose.errors[i]),
                                  -whitened.unknownGradient[eigenIndex(i)] / information, 1 / std::sqrt(information),
                                  pose.jointErrorGradient[eigenIndex(i)],
                                  pose.jointErrorGram(eigenIndex(i), eigenIndex(i))});
        }
      }
    }
  }
  return result;
}

} // namespace naocal
