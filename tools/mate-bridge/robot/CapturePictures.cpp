#include "robot/CapturePictures.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

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

/// Assigns a camera's recent images to its captures, the nearest in time first. Captures whose image is no longer among
/// the recent ones keep it.
bool CapturePictures::assignImages(const std::string& camera) {
  struct Pair {
    std::uint64_t off; // time difference between image and capture [ms]
    Taken* taken;
    const Seen* seen;
  };
  const std::deque<Seen>& recent = seen_[camera];
  const auto isRecent = [&](const std::shared_ptr<const std::string>& file) {
    return std::any_of(recent.begin(), recent.end(), [&](const Seen& seen) { return seen.file == file; });
  };
  std::vector<Pair> pairs;
  std::map<Taken*, std::shared_ptr<const std::string>> before;
  for (Taken& taken : taken_) {
    if (taken.camera != camera || !taken.time || (taken.file && !isRecent(taken.file))) {
      continue;
    }
    before[&taken] = std::exchange(taken.file, nullptr);
    for (const Seen& seen : recent) {
      if (const std::uint64_t off = distance(*taken.time, seen.time); off <= nearby) {
        pairs.push_back({off, &taken, &seen});
      }
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.off < b.off; });
  std::set<const Seen*> assigned;
  for (const auto& [off, taken, seen] : pairs) {
    if (!taken->file && assigned.insert(seen).second) {
      taken->file = seen->file;
    }
  }
  return std::any_of(before.begin(), before.end(), [](const auto& one) { return one.first->file != one.second; });
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
    }
  }
  for (const auto& [camera, recent] : seen_) {
    changed = assignImages(camera) || changed;
  }
  isFirst_ = false;
  return changed;
}

bool CapturePictures::onImage(const std::string& camera, std::uint64_t timestamp, std::string_view file) {
  std::deque<Seen>& pictures = seen_[camera];
  if (!pictures.empty() && timestamp < pictures.back().time) {
    pictures.clear(); // the robot was restarted
  }
  pictures.emplace_back(Seen{timestamp, std::make_shared<const std::string>(file)});
  while (pictures.front().time + patient < timestamp) {
    pictures.pop_front();
  }
  return assignImages(camera);
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
