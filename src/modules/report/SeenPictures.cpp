#include "report/SeenPictures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

namespace naocal {

namespace {

/// A list of [u, v]; predictions may lie far outside the picture.
Eigen::Matrix2Xd points(const JsonPlace& place, std::size_t count) {
  const std::vector<JsonPlace> entries = place.elements();
  if (entries.size() != count) {
    place.refuse("as many points as there are ids");
  }
  Eigen::Matrix2Xd result(2, static_cast<Eigen::Index>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<double> uAndV = entries[i].numbers(2, {-1e9, 1e9, "px"}, "u and v");
    result.col(static_cast<Eigen::Index>(i)) << uAndV[0], uAndV[1];
  }
  return result;
}

SeenBoard seenBoard(const JsonPlace& place) {
  SeenBoard board;
  board.board = place.at("board").text();
  for (const JsonPlace& id : place.at("ids").elements()) {
    board.ids.push_back(id.integer(0, largestNumber));
  }
  const std::size_t count = board.ids.size();
  if (count == 0) {
    place.at("ids").refuse("at least one corner");
  }
  board.measured = points(place.at("measured"), count);
  board.predicted = points(place.at("predicted"), count);
  board.fitted = points(place.at("fitted"), count);
  board.weight = place.at("weight").numbers(count, {0, 1, ""}, "one per corner");
  return board;
}

/// A text that may be empty.
std::string label(const JsonPlace& place) {
  return place.value().is_string() ? place.value().get<std::string>() : place.text();
}

SeenPicture seenPicture(const JsonPlace& place, const JsonPlace& cameras) {
  SeenPicture picture;
  picture.set = place.at("set").text();
  picture.capture = place.at("capture").integer(0, largestNumber);
  picture.pose = label(place.at("pose"));
  picture.repeat = place.at("repeat").integer(0, largestNumber);
  picture.time = place.at("time").number({-1e12, 1e12, "s"});
  picture.camera = place.at("camera").text();
  picture.image = label(place.at("image"));
  const JsonPlace camera = cameras.at(picture.set).at(picture.camera);
  picture.width = camera.at("width").integer(1, 100000);
  picture.height = camera.at("height").integer(1, 100000);
  return picture;
}

} // namespace

double SeenPicture::rms() const {
  double squares = 0, corners = 0;
  for (const SeenBoard& board : boards) {
    squares += (board.predicted - board.measured).squaredNorm();
    corners += static_cast<double>(board.ids.size());
  }
  return std::sqrt(squares / corners);
}

std::vector<SeenPicture> seenPictures(const JsonPlace& result) {
  const JsonPlace cameras = result.at("cameras");
  const JsonPlace sightings = result.at("sightings");
  std::map<std::pair<std::string, int>, SeenPicture> pictures;
  for (const JsonPlace& sighting : sightings.elements()) {
    SeenPicture picture = seenPicture(sighting, cameras);
    pictures.try_emplace({picture.set, picture.capture}, picture).first->second.boards.push_back(seenBoard(sighting));
  }
  if (pictures.empty()) {
    sightings.refuse("at least one board in a picture");
  }
  std::vector<SeenPicture> sorted;
  for (auto& [key, picture] : pictures) {
    sorted.push_back(std::move(picture));
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const SeenPicture& a, const SeenPicture& b) { return a.rms() > b.rms(); });
  return sorted;
}

} // namespace naocal
