#include "captures/CaptureWriter.hpp"

#include "captures/CaptureWords.hpp"
#include "captures/WrittenJson.hpp"

#include <cmath>

namespace naocal {
namespace {

using nlohmann::json;
using Written = nlohmann::ordered_json;

/// NaN, a joint that was not recorded, is null in JSON.
Written numbersJson(const std::vector<double>& numbers, bool whole) {
  Written list = Written::array();
  for (const double number : numbers) {
    list.push_back(whole && !std::isnan(number) ? Written(std::lround(number)) : Written(number));
  }
  return list;
}

Written jointsJson(const JointReadings& joints, const json& read) {
  Written known;
  for (const JointList& list : jointLists) {
    const auto& values = joints.*list.values;
    const bool isWritten = !values.empty() || list.values == &JointReadings::measured;
    known[list.key] = isWritten ? numbersJson(values, list.values == &JointReadings::approach) : Written();
  }
  return finished(known, read);
}

Written cornersJson(const BoardCorners& corners, const json& read) {
  Written uv = Written::array();
  for (const Eigen::Vector2d& corner : corners.uv) {
    uv.push_back({corner.x(), corner.y()});
  }
  return finished({{"board", corners.board}, {"ids", corners.ids}, {"uv", uv}}, read);
}

} // namespace

Written captureJson(const Capture& capture, const json& read) {
  Written known{{"id", capture.id},
                {"pose", capture.pose},
                {"repeat", capture.repeat},
                {"repeatKind", repeatKindWords[static_cast<std::size_t>(capture.repeatKind)]},
                {"time", capture.time.count()},
                {"camera", capture.camera},
                {"supportFoot", supportFootWords[static_cast<std::size_t>(capture.supportFoot)]},
                {"stance", capture.stance},
                {"joints", jointsJson(capture.joints, child(read, "joints"))},
                {"imu", nullptr},
                {"fsr", capture.fsr ? Written(*capture.fsr) : Written()},
                {"image", capture.image.empty() ? Written() : Written(capture.image)},
                {"corners", nullptr}};
  if (capture.imu) {
    known["imu"] = finished({{"angleX", capture.imu->x()}, {"angleY", capture.imu->y()}}, child(read, "imu"));
  }
  if (capture.corners) {
    known["corners"] = Written::array();
    for (const BoardCorners& corners : *capture.corners) {
      known["corners"].push_back(cornersJson(corners, entryWith("board", corners.board, child(read, "corners"))));
    }
  }
  return finished(known, read);
}

} // namespace naocal
