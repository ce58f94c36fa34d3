#include "report/SourceCaptures.hpp"

#include "calibration/Prediction.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"
#include "io/GreyImage.hpp"
#include "io/InputError.hpp"
#include "report/PageValues.hpp"
#include "robot/RobotOfSet.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <openssl/evp.h>
#include <utility>

namespace naocal {

namespace fs = std::filesystem;

namespace {

/// A list of [u, v]; predictions may lie far outside the image.
Eigen::Matrix2Xd points(const JsonCursor& place, std::size_t count) {
  const std::vector<JsonCursor> entries = place.elements();
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

BoardInPicture seenBoard(const JsonCursor& place) {
  BoardInPicture board;
  board.board = place.at("board").text();
  for (const JsonCursor& id : place.at("ids").elements()) {
    board.ids.push_back(id.integer(0, maxInteger));
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

PictureRecord seenPicture(const JsonCursor& place, const JsonCursor& cameras) {
  PictureRecord picture;
  picture.set = label(place.at("set"));
  picture.capture = place.at("capture").integer(0, maxInteger);
  picture.pose = label(place.at("pose"));
  picture.repeat = place.at("repeat").integer(0, maxInteger);
  picture.time = place.at("time").number({-1e12, 1e12, "s"});
  picture.camera = place.at("camera").text();
  picture.image = label(place.at("image"));
  const JsonCursor camera = cameras.at(picture.set).at(picture.camera);
  picture.width = camera.at("width").integer(1, CameraIntrinsics::mostPixels);
  picture.height = camera.at("height").integer(1, CameraIntrinsics::mostPixels);
  return picture;
}

/// Names of the sets in the result; in older files those of their folders.
std::vector<std::string> namesOf(const JsonCursor& inputs) {
  std::vector<std::string> names;
  const auto told = inputs.find("names");
  for (const JsonCursor& one : (told ? *told : inputs.at("sets")).elements()) {
    names.push_back(told ? label(one) : fs::path{one.text()}.lexically_normal().filename().string());
  }
  return names;
}

std::string base64(std::string_view bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0'); // OpenSSL appends a zero byte
  EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), reinterpret_cast<const unsigned char*>(bytes.data()),
                  static_cast<int>(bytes.size()));
  text.pop_back();
  return text;
}

} // namespace

double PictureRecord::rms() const {
  double squares = 0, corners = 0;
  for (const BoardInPicture& board : boards) {
    squares += (board.predicted - board.measured).squaredNorm();
    corners += static_cast<double>(board.ids.size());
  }
  return std::sqrt(squares / corners);
}

std::vector<PictureRecord> readPictures(const JsonCursor& result) {
  const JsonCursor cameras = result.at("cameras");
  const JsonCursor observations = result.at("sightings");
  std::map<std::pair<std::string, int>, PictureRecord> pictures;
  for (const JsonCursor& observation : observations.elements()) {
    PictureRecord picture = seenPicture(observation, cameras);
    pictures.try_emplace({picture.set, picture.capture}, picture)
        .first->second.boards.push_back(seenBoard(observation));
  }
  const auto readings = result.find("readings");
  if (pictures.empty() && (!readings || readings->elements().empty())) {
    observations.refuse("at least one board in a picture, or readings of trackers or contacts", "neither");
  }
  std::vector<PictureRecord> sorted;
  for (auto& [key, picture] : pictures) {
    sorted.push_back(std::move(picture));
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const PictureRecord& a, const PictureRecord& b) { return a.rms() > b.rms(); });
  return sorted;
}

SourceCaptures::SourceCaptures(const JsonCursor& result, const SetSearch& search) {
  const JsonCursor inputs = result.at("inputs");
  const std::vector<JsonCursor> folders = inputs.at("sets").elements(), sums = inputs.at("sha256").elements();
  names_ = namesOf(inputs);
  if (folders.size() != sums.size() || folders.size() != names_.size()) {
    inputs.at("sha256").refuse("as many sums and names as there are sets");
  }
  for (std::size_t i = 0; i < folders.size(); ++i) {
    SoughtSet sought = findSet({folders[i].text(), sums[i].text()}, search);
    if (!sought.folder) {
      missing_.push_back(std::move(sought.sentence));
      continue;
    }
    try {
      unchanged_[names_[i]] = {*sought.folder, readCaptureSet(*sought.folder, BadCapturePolicy::skip).set};
      unchanged_[names_[i]].set.name = names_[i];
      if (!sought.sentence.empty()) {
        moved_.push_back(std::move(sought.sentence));
      }
    } catch (const InputError& error) {
      missing_.emplace_back(error.what());
    }
  }
  addJointUnits();
}

void SourceCaptures::addJointUnits() {
  for (const auto& [name, source] : unchanged_) {
    try {
      for (const Joint& joint : loadRobot(source.set).joints) {
        jointUnits_[joint.name] = joint.isPrismatic ? "m" : "rad";
      }
    } catch (const InputError&) { // no drawing of this robot
    }
  }
}

std::map<std::string, JointReading> SourceCaptures::jointReadings(const std::string& setName, int id) const {
  std::map<std::string, JointReading> result;
  const auto source = unchanged_.find(setName);
  if (source == unchanged_.end()) {
    return result;
  }
  const CaptureSet& set = source->second.set;
  const auto capture =
      std::find_if(set.captures.begin(), set.captures.end(), [&](const Capture& one) { return one.id == id; });
  for (std::size_t i = 0; capture != set.captures.end() && i < set.jointNames.size(); ++i) {
    if (std::isfinite(capture->joints.measured[i])) {
      const auto unit = jointUnits_.find(set.jointNames[i]);
      result[set.jointNames[i]] = {capture->joints.measured[i], unit == jointUnits_.end() ? "rad" : unit->second};
    }
  }
  return result;
}

std::optional<fs::path> SourceCaptures::image(const PictureRecord& picture) const {
  const auto source = unchanged_.find(picture.set);
  const auto file =
      source == unchanged_.end() ? std::nullopt : fileInside(source->second.folder, fs::path{picture.image});
  std::error_code ignored;
  return file && fs::is_regular_file(*file, ignored) ? file : std::nullopt;
}

std::optional<DrawingErrors> SourceCaptures::drawingErrors() const {
  std::vector<CaptureSet> sets;
  for (const auto& [name, source] : unchanged_) {
    sets.push_back(source.set);
  }
  if (sets.empty() || !missing_.empty()) {
    return std::nullopt;
  }
  try {
    const Comparison comparison = compare(StoredResult{}, sets, loadRobot(sets), false);
    return DrawingErrors{comparison.nominal.rmsPx, comparison.nominalReadings};
  } catch (const InputError&) { // no drawing of this robot, or corners behind a camera
    return std::nullopt;
  }
}

std::optional<std::string> makeThumbnail(const std::filesystem::path& file, const PictureSize& described) {
  constexpr int widest = 640; // [px]
  try {
    GreyPicture picture = readImage(file, described);
    cv::Mat grey{picture.height, picture.width, CV_8UC1, picture.pixels.data()};
    if (grey.cols > widest) {
      const double scale = static_cast<double>(widest) / grey.cols;
      cv::resize(grey, grey, {widest, std::max(1, cvRound(scale * grey.rows))}, 0, 0, cv::INTER_AREA);
    }
    return "data:image/jpeg;base64," + base64(encodeJpeg({grey.data, grey.total()}, grey.cols, grey.rows, 70));
  } catch (const InputError&) { // missing, broken or of another size: no thumbnail
    return std::nullopt;
  }
}

} // namespace naocal
