#include "robot/CapturePictures.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

constexpr std::uint64_t patient = 4000,
                        nearby = 1000; // how long pictures wait for captures; how far one may be off [ms]
constexpr std::size_t mostTaken = 400; // captures with stored images

std::uint64_t distance(std::uint64_t a, std::uint64_t b) {
  return a < b ? b - a : a - b;
}

} // namespace

void CapturePictures::beginWatch() {
  isFirst_ = true;
  seen_.clear();
}

/// Assigns the image if it is nearer in time than the present one.
bool CapturePictures::offer(Taken& taken, const Seen& seen) const {
  const std::uint64_t off = taken.time ? distance(*taken.time, seen.time) : nearby + 1;
  if (off > nearby || (taken.file && taken.off <= off)) {
    return false;
  }
  taken.file = seen.file;
  taken.off = off;
  return true;
}

bool CapturePictures::onCaptures(const Json& captures, std::uint64_t timestamp) {
  bool changed = false;
  const auto nameOf = [](const Json& capture) {
    return fmt::format("{}/{}/{}/{}", capture.at("number").get<int>(), capture.at("round").get<int>(),
                       capture.at("pose").get<std::string>(), capture.at("camera").get<std::string>());
  };
  bool isAnother = captures.size() < taken_.size();
  for (std::size_t i = 0; i < taken_.size() && !isAnother; ++i) {
    isAnother = nameOf(captures.at(i)) != taken_[i].name;
  }
  if (isAnother) {
    taken_.clear();
    ++series_;
    changed = true;
  }
  for (std::size_t i = taken_.size(); i < captures.size() && i < mostTaken; ++i) {
    Taken& taken = taken_.emplace_back();
    taken.name = nameOf(captures.at(i));
    taken.camera = captures.at(i).at("camera");
    if (!isFirst_) {
      taken.time = timestamp;
      for (const Seen& seen : seen_[taken.camera]) {
        changed = offer(taken, seen) || changed;
      }
    }
  }
  isFirst_ = false;
  return changed;
}

bool CapturePictures::onImage(const std::string& camera, std::uint64_t timestamp, std::string_view file) {
  std::deque<Seen>& pictures = seen_[camera];
  if (!pictures.empty() && timestamp < pictures.back().time) {
    pictures.clear(); // the robot was restarted
  }
  const Seen& seen = pictures.emplace_back(Seen{timestamp, std::make_shared<const std::string>(file)});
  bool changed = false;
  for (Taken& taken : taken_) {
    changed = (taken.camera == camera && offer(taken, seen)) || changed;
  }
  while (pictures.front().time + patient < timestamp) {
    pictures.pop_front();
  }
  return changed;
}

Json CapturePictures::list() const {
  Json places = Json::array();
  for (std::size_t i = 0; i < taken_.size(); ++i) {
    if (taken_[i].file) {
      places.push_back(i);
    }
  }
  return {{"series", series_}, {"places", std::move(places)}};
}

std::optional<std::string> CapturePictures::picture(std::size_t series, std::size_t place) const {
  return series == series_ && place < taken_.size() && taken_[place].file ? std::optional{*taken_[place].file}
                                                                          : std::nullopt;
}

} // namespace naocal
