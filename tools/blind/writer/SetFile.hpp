#pragma once

#include "world/Pictures.hpp"
#include "writer/SessionPlanner.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace blind {

/// Simulated detections: true corners plus noise, by sight.
using ObservedCorners = std::vector<std::vector<Eigen::Vector2d>>;

/// Adds the regime's noise to all corners [px].
ObservedCorners noisyCorners(const TruePictures& pictures, const Session& session, const NoiseRegime& noise,
                             RandomStream& chance);

/// The capture set as JSON in naocal's format, without placements. With `pictures` the captures name images instead of
/// corners.
nlohmann::json captureSetJson(const Drawing& drawing, const Session& session, const ObservedCorners& seen,
                              bool pictures, const std::string& robotName);

/// Path of a capture's image inside the set's folder.
std::string imageName(int reading, int camera);

} // namespace blind
