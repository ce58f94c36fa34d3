#pragma once

#include "poses/PlannedCaptures.hpp"
#include "residuals/Noise.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace naocal {

/// `poses` of POSES.json: each with the seconds from the one before it, where these are known.
nlohmann::json posesOf(const std::vector<ProposedPose>& poses, const std::vector<std::optional<double>>& seconds,
                       const Robot& robot);

/// Angles by name, fingers at rest.
nlohmann::json anglesJson(const Eigen::VectorXd& angles, const Robot& robot);

/// Where boards lie on the floor.
nlohmann::json boardsJson(const std::vector<Board>& boards);

nlohmann::json noiseJson(const Noise& noise);

} // namespace naocal
