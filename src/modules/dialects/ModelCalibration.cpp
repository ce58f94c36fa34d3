#include "dialects/ModelCalibration.hpp"

#include "calibration/Initialization.hpp"
#include "effects/Catalogue.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace naocal {
namespace {

using Values = std::map<std::string, double>;

double valueAt(const Values& values, const std::string& name) {
  const auto found = values.find(name);
  return found == values.end() ? 0 : found->second;
}

/// A number of each camera's distortion: where it is in the list, and the unknown that is added to it.
struct DistortionTerm {
  std::size_t index;
  const char *effect, *unknown;
};
constexpr std::array distortionTerms{
    DistortionTerm{0, "radialDistortion", "k1"}, DistortionTerm{1, "radialDistortion", "k2"},
    DistortionTerm{2, "tangentialDistortion", "p1"}, DistortionTerm{3, "tangentialDistortion", "p2"}};

std::string unknownName(const std::string& effect, const std::string& place, const std::string& unknown) {
  return fmt::format("{}@{}.{}", effect, place, unknown);
}

std::optional<Eigen::Vector3d> vectorOf(const Values& values, const std::string& effect, const std::string& camera,
                                        const std::array<const char*, 3>& unknowns) {
  if (!values.contains(unknownName(effect, camera, unknowns[0]))) {
    return std::nullopt;
  }
  Eigen::Vector3d vector;
  for (int i = 0; i < 3; ++i) {
    vector[i] = valueAt(values, unknownName(effect, camera, unknowns[static_cast<std::size_t>(i)]));
  }
  return vector;
}

constexpr std::array rotationNames{"rx", "ry", "rz"}, shiftNames{"x", "y", "z"};

CameraIntrinsics correctedLens(CameraIntrinsics lens, const std::string& camera, const Values& values) {
  const double scale = 1 + valueAt(values, unknownName("focalLength", camera, "s"));
  lens.fx *= scale;
  lens.fy *= scale;
  lens.cx += valueAt(values, unknownName("principalPoint", camera, "x"));
  lens.cy += valueAt(values, unknownName("principalPoint", camera, "y"));
  for (const DistortionTerm& term : distortionTerms) {
    lens.distortion[term.index] += valueAt(values, unknownName(term.effect, camera, term.unknown));
  }
  return lens;
}

void addLensValues(const CameraIntrinsics& lens, const CameraIntrinsics& ofSet, const std::string& camera,
                   Values& values) {
  const double wide = static_cast<double>(ofSet.width) / lens.width;
  const double high = static_cast<double>(ofSet.height) / lens.height;
  values[unknownName("focalLength", camera, "s")] = (wide * lens.fx / ofSet.fx + high * lens.fy / ofSet.fy) / 2 - 1;
  // pixel (0, 0) is a centre: the picture's edge lies at -0.5
  values[unknownName("principalPoint", camera, "x")] = wide * (lens.cx + 0.5) - 0.5 - ofSet.cx;
  values[unknownName("principalPoint", camera, "y")] = high * (lens.cy + 0.5) - 0.5 - ofSet.cy;
  for (const DistortionTerm& term : distortionTerms) {
    values[unknownName(term.effect, camera, term.unknown)] = lens.distortion[term.index] - ofSet.distortion[term.index];
  }
}

} // namespace

RobotCalibration calibrationFromValues(const Values& values, const std::map<std::string, CameraIntrinsics>& lenses) {
  RobotCalibration calibration;
  for (const std::string_view joint : offsetJoints()) {
    const auto found = values.find(unknownName(effectName::jointOffset, std::string{joint}, "o"));
    if (found != values.end()) {
      calibration.offsets[std::string{joint}] = found->second;
    }
  }
  for (const char* const camera : {"top", "bottom"}) {
    CameraCalibration one{vectorOf(values, effectName::cameraRotation, camera, rotationNames),
                          vectorOf(values, "cameraTranslation", camera, shiftNames),
                          {}};
    if (const auto lens = lenses.find(camera); lens != lenses.end()) {
      one.lens = correctedLens(lens->second, camera, values);
    }
    if (one.rotation || one.translation || one.lens) {
      calibration.cameras[camera] = one;
    }
  }
  return calibration;
}

Values valuesFromCalibration(const RobotCalibration& calibration,
                             const std::map<std::string, CameraIntrinsics>& lenses) {
  Values values;
  for (const auto& [joint, offset] : calibration.offsets) {
    values[unknownName(effectName::jointOffset, joint, "o")] = offset;
  }
  for (const auto& [name, camera] : calibration.cameras) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (camera.rotation) {
        values[unknownName(effectName::cameraRotation, name, rotationNames[i])] =
            (*camera.rotation)[static_cast<Eigen::Index>(i)];
      }
      if (camera.translation) {
        values[unknownName("cameraTranslation", name, shiftNames[i])] =
            (*camera.translation)[static_cast<Eigen::Index>(i)];
      }
    }
    const auto ofSet = lenses.find(name);
    if (camera.lens && ofSet != lenses.end()) {
      addLensValues(*camera.lens, ofSet->second, name, values);
    }
  }
  return values;
}

SearchStart startAt(const Values& values, const Measurements& measurements, const Model& model) {
  SearchStart start{Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.unknownCount())), 0, {}};
  const std::vector<std::string> names = model.names();
  for (const auto& [name, value] : values) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) {
      start.unknowns[found - names.begin()] = value;
      ++start.count;
    } else if (std::abs(value) > 1e-6) {
      start.unused.push_back(name);
    }
  }
  start.unknowns = alignBoards(measurements, model, start.unknowns);
  return start;
}

} // namespace naocal
