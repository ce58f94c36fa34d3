#include "dialects/Dialects.hpp"

#include "dialects/BHuman.hpp"
#include "dialects/Hulks.hpp"
#include "dialects/HulksTree.hpp"
#include "dialects/Kalibr.hpp"
#include "dialects/NaoDevils.hpp"
#include "dialects/RosCameraInfo.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace naocal {
namespace {

const std::array knownDialects{
    Dialect{"hulks", "HULKs 2019: degrees by joint, rotations in radians", false, true, writeHulks, parseHulks},
    Dialect{"hulks-tree", "HULKs 2024: the tree of parameters, offsets in radians", false, true, writeHulksTree,
            parseHulksTree},
    Dialect{"bhuman", "B-Human since 2019: offsets = {...}", true, true, writeBHuman, parseBHuman},
    Dialect{"bhuman-joints", "B-Human before: joints = {...} with limits", true, true, writeOlderBHuman, parseBHuman},
    Dialect{"naodevils", "Nao Devils: offset with limits by joint", true, true, writeNaoDevils, parseNaoDevils},
    Dialect{"ros", "ROS camera_info: lenses", false, false, writeRosCameraInfo, parseRosCameraInfo},
    Dialect{"kalibr", "kalibr: lenses, and the cameras' relative placement", false, false, writeKalibr, parseKalibr}};

constexpr double lost = 1e-6; // [rad], [m], [px] that count as lost; above what printing rounds away

bool differs(const std::optional<Eigen::Vector3d>& one, const std::optional<Eigen::Vector3d>& other) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  return (one.value_or(zero) - other.value_or(zero)).norm() > lost;
}

bool differs(const std::array<double, 5>& one, const std::array<double, 5>& other) {
  return !std::equal(one.begin(), one.end(), other.begin(), [](double a, double b) { return std::abs(a - b) <= lost; });
}

void addCamera(const std::string& name, const CameraCalibration& given, const CameraCalibration& kept,
               std::vector<std::string>& words) {
  if (given.rotation && differs(given.rotation, kept.rotation)) {
    words.push_back("the rotation of camera " + name);
  }
  if (given.translation && differs(given.translation, kept.translation)) {
    words.push_back("the shift of camera " + name);
  }
  if (given.lens && !kept.lens) {
    words.push_back("the lens of camera " + name);
  } else if (given.lens && differs(given.lens->distortion, kept.lens->distortion)) {
    words.push_back("the distortion of camera " + name);
  }
}

} // namespace

std::span<const Dialect> dialects() {
  return knownDialects;
}

std::vector<std::string> dialectNames() {
  std::vector<std::string> names;
  for (const Dialect& dialect : knownDialects) {
    names.emplace_back(dialect.name);
  }
  return names;
}

const Dialect& findDialect(const std::string& name) {
  const auto found = std::find_if(knownDialects.begin(), knownDialects.end(),
                                  [&](const Dialect& dialect) { return dialect.name == name; });
  if (found == knownDialects.end()) {
    throw InputError{fmt::format("expected one of {}, found \"{}\"", fmt::join(dialectNames(), ", "), name)};
  }
  return *found;
}

std::vector<std::string> unwritten(const Dialect& dialect, const RobotCalibration& calibration, const Robot& robot) {
  ParsedCalibration again;
  for (const DialectFile& file : dialect.write(calibration, robot)) {
    addCalibration(dialect.parse(file.text, file.name, robot), file.name, again);
  }
  std::vector<std::string> words;
  const bool losesJoints = std::any_of(calibration.offsets.begin(), calibration.offsets.end(), [&](const auto& offset) {
    return offset.second != 0 && !again.calibration.offsets.contains(offset.first);
  });
  if (losesJoints) {
    words.push_back("joint offsets");
  }
  for (const auto& [name, camera] : calibration.cameras) {
    const auto kept = again.calibration.cameras.find(name);
    addCamera(name, camera, kept == again.calibration.cameras.end() ? CameraCalibration{} : kept->second, words);
  }
  return words;
}

} // namespace naocal
