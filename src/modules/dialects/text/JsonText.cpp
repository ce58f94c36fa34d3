#include "dialects/text/JsonText.hpp"

#include "io/InputError.hpp"
#include "protocol/BoundedJson.hpp"

#include <fmt/format.h>
#include <vector>

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

CameraIntrinsics readLensShares(const JsonCursor& focal, const JsonCursor& centre) {
  constexpr Range range{0.01, 100, "of the picture"};
  const std::vector<double> focalShares = focal.numbers(2, range, "of width and height"),
                            centreShares = centre.numbers(2, range, "of width and height");
  CameraIntrinsics lens;
  lens.fx = focalShares[0] * lens.width;
  lens.fy = focalShares[1] * lens.height;
  lens.cx = centreShares[0] * lens.width;
  lens.cy = centreShares[1] * lens.height;
  return lens;
}

} // namespace naocal
