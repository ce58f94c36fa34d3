#include "report/PictureData.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace naocal {

using nlohmann::json;

double withDecimals(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

namespace {

/// u and v of every corner, one after the other.
json flat(const Eigen::Matrix2Xd& points, int decimals) {
  json list = json::array();
  for (const double value : points.reshaped()) {
    list.push_back(withDecimals(value, decimals));
  }
  return list;
}

json boardJson(const SeenBoard& seen) {
  json board{{"board", seen.board},
             {"ids", seen.ids},
             {"measured", flat(seen.measured, 1)},
             {"reported", flat(seen.predicted - seen.measured, 3)},
             {"fitted", flat(seen.fitted - seen.measured, 3)}};
  if (std::any_of(seen.weight.begin(), seen.weight.end(), [](double weight) { return weight < 1; })) {
    board["weight"] = json::array();
    for (const double weight : seen.weight) {
      board["weight"].push_back(withDecimals(weight, 2));
    }
  }
  return board;
}

} // namespace

json pictureJson(const SeenPicture& seen) {
  json picture{{"set", seen.set},       {"capture", seen.capture}, {"pose", seen.pose},
               {"repeat", seen.repeat}, {"time", seen.time},       {"camera", seen.camera},
               {"width", seen.width},   {"height", seen.height},   {"boards", json::array()}};
  for (const SeenBoard& board : seen.boards) {
    picture["boards"].push_back(boardJson(board));
  }
  return picture;
}

} // namespace naocal
