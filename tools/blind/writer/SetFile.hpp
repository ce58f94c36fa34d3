#pragma once

#include "writer/Pictures.hpp"
#include "writer/SessionPlanner.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace blind {

/// What a detector would report: true corners and noise, by sight.
using ObservedCorners = std::vector<std::vector<Eigen::Vector2d>>;

ObservedCorners noisyCorners(const TruePictures& pictures, const Session& session, const NoiseRegime& noise,
                             RandomStream& chance);

/// The capture set as contracts/captures.md has it; no placement is told. With pictures the captures name images and
/// hold no corners.
nlohmann::json captureSetJson(const Drawing& drawing, const Session& session, const ObservedCorners& seen,
                              bool pictures, const std::string& robotName);

/// Where a capture's picture lies inside the set's folder.
std::string imageName(int reading, int camera);

} // namespace blind
