#pragma once

#include "evaluation/thesis/ThesisProgram.hpp"
#include "evaluation/thesis/ThesisTrial.hpp"

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace naocal {

/// Plain files of the thesis's evaluation: CSV with commas; the first line, a comment (#), names the kind, the next one
/// the columns; further comments and empty lines are ignored. Readers take the files of the thesis's own program as
/// well: 26 errors per line; NaoPoseAndRawAngles; GroundGrid and ChessBoardPatternOnFloor (on the floor where the file
/// says, not at the foot). All throw InputError with file, line, expected and found.

/// First lines of the files that are written.
inline constexpr std::string_view errorsKind = "# naocal evaluate thesis: error sets, joint offsets [rad], true angle "
                                               "= reading - offset";
inline constexpr std::string_view posesKind = "# naocal evaluate thesis: poses, joint angles [rad], left foot";
inline constexpr std::string_view featuresKind = "# naocal evaluate thesis: floor points [m, rad], in the left sole's "
                                                 "frame";
inline constexpr std::string_view rowsKind = "# naocal evaluate thesis: one row per error set, angles in rad";

/// A row per error set or pose, one number per name [rad]. Columns of other joints of the robot are ignored. `range`:
/// largest magnitude accepted [rad].
struct JointColumns {
  const Robot& robot;
  std::vector<std::string> names;
  double range = 0;
};
std::vector<Eigen::VectorXd> readErrorSets(const std::filesystem::path& file, const JointColumns& columns);
std::vector<Eigen::VectorXd> readPoses(const std::filesystem::path& file, const JointColumns& columns);
std::vector<FloorPattern> readFeatures(const std::filesystem::path& file);

/// The same files' texts.
std::string formatJointTable(std::string_view kind, const std::vector<std::string>& names,
                             const std::vector<Eigen::VectorXd>& rows);
std::string formatFeatures(const std::vector<FloorPattern>& features);

/// One error set, as one solver left it.
struct ThesisRow {
  ThesisSetting setting;
  std::size_t set = 0;
  ThesisSolver solver = ThesisSolver::plain;
  ThesisSolution solution;
  Eigen::VectorXd offsets; // true ones, per joint [rad]
};

/// Rows by setting, set and solver: feature, poses, noise, jointNoise, samples, solver, set, status (at the tolerance
/// `tolerance` [rad]), calibrationRmsPx, testErrorPx (empty without held-out poses), then per joint the residual
/// ("residual HeadYaw") and injected offset ("injected HeadYaw").
std::string formatRows(std::vector<ThesisRow> rows, const std::vector<std::string>& names, double tolerance);

} // namespace naocal
