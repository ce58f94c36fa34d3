#pragma once

#include "data/Capture.hpp"
#include "dialects/text/Decimals.hpp"
#include "io/JsonReader.hpp"

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>

namespace naocal {

/// A JSON document with `//` and `/* */` comments, as HULKs' files have them. Throws InputError with file, line and
/// column.
nlohmann::json parseCommentedJson(const std::string& text, const std::string& file);

/// Focal length and principal point as shares of the picture's width and height.
struct LensShares {
  Eigen::Vector2d focal, centre;
};
LensShares sharesOf(const CameraIntrinsics& lens);

/// Reads a lens without distortion from two shares each; the picture has 640 x 480 pixels.
CameraIntrinsics readLensShares(const JsonCursor& focal, const JsonCursor& centre);

/// Numbers as a JSON list, rounded to some digits behind the point.
template <typename Vector> nlohmann::ordered_json roundedList(const Vector& numbers, int digits) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (Eigen::Index i = 0; i < numbers.size(); ++i) {
    list.push_back(roundDecimal(numbers[i], digits));
  }
  return list;
}

} // namespace naocal
