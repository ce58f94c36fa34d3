#include "dialects/BHuman.hpp"

#include "dialects/MapCalibration.hpp"
#include "protocol/JointOrder.hpp"

#include <array>
#include <fmt/format.h>
#include <utility>

namespace naocal {
namespace {

constexpr std::array cameraWords{std::pair{"lower", "bottom"}, std::pair{"upper", "top"}};

/// cameraCalibration.cfg, if a rotation is known.
void addCorrections(const RobotCalibration& calibration, std::vector<DialectFile>& files, const std::string& text) {
  for (const auto& [name, camera] : calibration.cameras) {
    if (camera.rotation) {
      files.push_back({"cameraCalibration.cfg", text + "bodyRotationCorrection = {x = 0deg; y = 0deg;};\n"});
      return;
    }
  }
}

std::string correctionsText(const RobotCalibration& calibration) {
  std::string text = "cameraRotationCorrections = {\n";
  for (const auto& [theirs, ours] : cameraWords) {
    text += fmt::format("  {} = {};\n", theirs, mapCorrection(calibration, ours));
  }
  return text + "};\n";
}

} // namespace

std::vector<DialectFile> writeBHuman(const RobotCalibration& calibration, const Robot&) {
  std::vector<DialectFile> files;
  if (!calibration.offsets.empty()) {
    std::string text = "offsets = {\n";
    for (const std::string_view joint : mapJoints()) {
      text += fmt::format("  {} = {};\n", offsetKey(joint), mapOffset(calibration, joint));
    }
    files.push_back({"jointCalibration.cfg", text + "};\n"});
  }
  addCorrections(calibration, files, correctionsText(calibration));
  std::string lenses;
  for (const auto& [theirs, ours] : cameraWords) {
    const auto camera = calibration.cameras.find(ours);
    if (camera != calibration.cameras.end() && camera->second.lens) {
      const MapLens lens = mapLens(*camera->second.lens);
      lenses += fmt::format("  {} = {{\n    openingAngleWidth = {};\n    openingAngleHeight = {};\n    opticalCenter = "
                            "{};\n  }};\n",
                            theirs, lens.width, lens.height, lens.centre);
    }
  }
  if (!lenses.empty()) {
    files.push_back({"cameraIntrinsics.cfg", "cameras = {\n" + lenses + "};\n"});
  }
  return files;
}

std::vector<DialectFile> writeOlderBHuman(const RobotCalibration& calibration, const Robot& robot) {
  std::vector<DialectFile> files;
  if (!calibration.offsets.empty()) {
    files.push_back(
        {"jointCalibration.cfg", "joints = {\n" + jointsWithLimits(calibration, robot, "  ", "1") + "};\n"});
  }
  std::string corrections, lenses;
  for (const auto& [theirs, ours] : cameraWords) {
    corrections += fmt::format("{}CameraRotationCorrection = {};\n", theirs, mapCorrection(calibration, ours));
    const auto camera = calibration.cameras.find(ours);
    if (camera != calibration.cameras.end() && camera->second.lens) {
      const MapLens lens = mapLens(*camera->second.lens);
      lenses += fmt::format("{0}OpeningAngleWidth = {1};\n{0}OpeningAngleHeight = {2};\n{0}OpticalCenter = {3};\n",
                            theirs, lens.width, lens.height, lens.centre);
    }
  }
  addCorrections(calibration, files, corrections);
  if (!lenses.empty()) {
    files.push_back({"cameraIntrinsics.cfg", lenses});
  }
  return files;
}

ParsedCalibration parseBHuman(const std::string& text, const std::string& file, const Robot&) {
  return parseMapCalibration(text, file);
}

} // namespace naocal
