#pragma once

#include "dialects/RobotCalibration.hpp"
#include "estimation/Model.hpp"

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

namespace naocal {

/// A result's numbers as a calibration: `values` by unknown ("jointOffset@LKneePitch.o"), `lenses` those of the capture
/// sets by camera, to which focalLength, principalPoint and the distortions are added.
RobotCalibration calibrationFromValues(const std::map<std::string, double>& values,
                                       const std::map<std::string, CameraIntrinsics>& lenses);

/// The inverse: values of the unknowns that lead to this calibration. A lens is told relative to that of the capture
/// set and scaled to its picture size; both focal lengths share one number, their mean.
std::map<std::string, double> valuesFromCalibration(const RobotCalibration& calibration,
                                                    const std::map<std::string, CameraIntrinsics>& lenses);

/// Start of a search: the unknowns of a model at these values, and the placements from the pictures, as
/// `CalibrationOptions::start`. `unused`: values of other unknowns, that are not 0 (1e-6).
struct SearchStart {
  Eigen::VectorXd unknowns;
  std::size_t count = 0; // unknowns that have a value
  std::vector<std::string> unused;
};
SearchStart startAt(const std::map<std::string, double>& values, const Measurements& measurements, const Model& model);

} // namespace naocal
