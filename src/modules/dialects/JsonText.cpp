#include "dialects/JsonText.hpp"

#include "io/InputError.hpp"
#include "protocol/BoundedJson.hpp"

#include <fmt/format.h>

namespace naocal {

nlohmann::json parseCommentedJson(const std::string& text, const std::string& file) {
  try {
    return parseBoundedJson(text, true);
  } catch (const nlohmann::json::exception& error) {
    throw InputError{fmt::format("{}: expected valid JSON, found a {}", file, parseErrorReason(error))};
  }
}

LensShares sharesOf(const CameraIntrinsics& lens) {
  return {{lens.fx / lens.width, lens.fy / lens.height}, {lens.cx / lens.width, lens.cy / lens.height}};
}

CameraIntrinsics lensFromShares(const std::vector<double>& focal, const std::vector<double>& centre) {
  CameraIntrinsics lens;
  lens.fx = focal[0] * lens.width;
  lens.fy = focal[1] * lens.height;
  lens.cx = centre[0] * lens.width;
  lens.cy = centre[1] * lens.height;
  return lens;
}

} // namespace naocal
