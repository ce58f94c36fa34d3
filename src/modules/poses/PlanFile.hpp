#pragma once

#include "poses/PosePlan.hpp"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// POSES.json of a plan.
nlohmann::json planJson(const PosePlan& plan, const Robot& robot);

/// Writes each pose to `<folder>/<id>.pose`, as HULKs' robots read them: 26 angles in radians, joints in the drawing's
/// order, fingers behind their wrists.
void writePoseFiles(const PosePlan& plan, const Robot& robot, const std::filesystem::path& folder);

/// Reads such a file: angles per joint of the drawing [rad]. Throws InputError for one that does not hold 26 angles.
Eigen::VectorXd readAnglesFile(const std::filesystem::path& file, const Robot& robot);

} // namespace naocal
