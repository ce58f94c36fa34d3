#include "dialects/Hulks.hpp"

#include "dialects/text/Decimals.hpp"
#include "dialects/text/JsonText.hpp"
#include "math/Angles.hpp"
#include "protocol/JointOrder.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using Json = nlohmann::ordered_json;

constexpr Range offsetRange{-180, 180, "degrees"};

/// Rotation and lens of one camera, where the file has them. True if it has.
bool readCamera(const JsonCursor& all, const std::string& name, RobotCalibration& calibration) {
  const auto rotation = all.find(name + "_ext"), focal = all.find(name + "_fc"), centre = all.find(name + "_cc");
  if (!rotation && !focal && !centre) {
    return false;
  }
  CameraCalibration& camera = calibration.cameras[name];
  if (rotation) {
    camera.rotation = Eigen::Vector3d{rotation->numbers(3, {-3.2, 3.2, "rad"}, "roll, pitch, yaw").data()};
  }
  if (focal || centre) {
    camera.lens = readLensShares(all.at(name + "_fc"), all.at(name + "_cc"));
  }
  return true;
}

} // namespace

std::vector<DialectFile> writeHulks(const RobotCalibration& calibration, const Robot&) {
  Json joints = Json::object(), cameras = Json::object();
  for (const std::string_view joint : jointNames) {
    if (const auto offset = findOffset(calibration, joint)) {
      joints[offsetKey(joint)] = roundDecimal(degrees(*offset), decimals::degree);
    }
  }
  for (const char* const name : {"top", "bottom"}) {
    const auto camera = calibration.cameras.find(name);
    if (camera != calibration.cameras.end() && camera->second.rotation) {
      cameras[fmt::format("{}_ext", name)] = roundedList(*camera->second.rotation, decimals::radian);
    }
    if (camera != calibration.cameras.end() && camera->second.lens) {
      const LensShares shares = sharesOf(*camera->second.lens);
      cameras[fmt::format("{}_fc", name)] = roundedList(shares.focal, decimals::share);
      cameras[fmt::format("{}_cc", name)] = roundedList(shares.centre, decimals::share);
    }
  }
  std::vector<DialectFile> files;
  for (const auto& [name, content] :
       {std::pair{"JointCalibrationProvider.json", &joints}, std::pair{"Projection.json", &cameras}}) {
    if (!content->empty()) {
      files.push_back({name, content->dump(2) + "\n"});
    }
  }
  return files;
}

ParsedCalibration parseHulks(const std::string& text, const std::string& file, const Robot&) {
  const nlohmann::json document = parseCommentedJson(text, file);
  const JsonCursor all{document, file};
  ParsedCalibration parsed;
  std::size_t used = 0;
  for (const std::string_view joint : jointNames) {
    if (const auto offset = all.find(offsetKey(joint))) {
      addOffset(std::string{joint}, radians(offset->number(offsetRange)), parsed);
      ++used;
    }
  }
  const bool hasTop = readCamera(all, "top", parsed.calibration),
             hasBottom = readCamera(all, "bottom", parsed.calibration);
  if (used == 0 && !hasTop && !hasBottom) {
    all.refuse("offsets as in JointCalibrationProvider.json (lKneePitch), or cameras as in Projection.json (top_ext)",
               "none of them");
  }
  for (const auto& [key, value] : document.items()) {
    const bool isCamera = key.ends_with("_ext") || key.ends_with("_fc") || key.ends_with("_cc");
    const bool isJoint = std::any_of(jointNames.begin(), jointNames.end(),
                                     [&, &word = key](std::string_view joint) { return offsetKey(joint) == word; });
    if (!isJoint && !isCamera) {
      parsed.unused.push_back(key);
    }
  }
  return parsed;
}

} // namespace naocal
