#pragma once

#include "data/Capture.hpp"

#include <Eigen/Core>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// Calibration of one camera; absent parts are unknown.
struct CameraCalibration {
  std::optional<Eigen::Vector3d> rotation;    // rx, ry, rz [rad]: headFromCamera = nominal * Rx(rx) Ry(ry) Rz(rz)
  std::optional<Eigen::Vector3d> translation; // shift of the mount in the head: x, y, z [m]
  std::optional<CameraIntrinsics> lens;
};

/// A robot's calibration as configuration files hold it: one constant per joint, mounts and lenses. The common value of
/// all dialects.
struct RobotCalibration {
  std::map<std::string, double> offsets;            // by joint (a NAO's: HULKs' names): reading minus true angle [rad]
  std::map<std::string, CameraCalibration> cameras; // of a NAO: "top", "bottom"
  std::string headId, bodyId;                       // serial numbers; empty: unknown
  std::string robot = "";                           // other than a NAO: its name
};

/// Names of the joints that have an offset of their own, in HULKs' order: all but hands, which have no angle, and the
/// right hip yaw-pitch, which the left one's motor drives.
std::vector<std::string_view> offsetJoints();

/// Offset of a joint, by HULKs' name [rad]; that of the right hip yaw-pitch is the left one's. Absent if unknown.
std::optional<double> findOffset(const RobotCalibration& calibration, std::string_view joint);

/// A calibration read from a dialect's file, and sentences on what of the file it does not hold.
struct ParsedCalibration {
  RobotCalibration calibration;
  std::vector<std::string> unused;
};

/// Adds a joint's offset [rad] from a file; `joint` is one of HULKs' names. Hands and a right hip yaw-pitch that
/// differs from the left one go to `unused` where they are not 0.
void addOffset(const std::string& joint, double offset, ParsedCalibration& parsed);

/// Adds everything of `other`. Throws InputError if both have the same number; `file` is that of `other`.
void addCalibration(const ParsedCalibration& other, const std::string& file, ParsedCalibration& all);

/// The calibration with the numbers of `present` where it has none of its own.
RobotCalibration completeCalibration(RobotCalibration calibration, const RobotCalibration& present);

/// CALIBRATION.json (`naocal-calibration`), the form in which `naocal import` hands a calibration to `naocal solve
/// --start` and `naocal export`. Reading throws InputError with file, place, expected and found.
nlohmann::json calibrationJson(const RobotCalibration& calibration);
RobotCalibration parseCalibration(const nlohmann::json& document, const std::string& name);

} // namespace naocal
