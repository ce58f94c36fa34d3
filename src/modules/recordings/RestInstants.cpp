#include "recordings/RestInstants.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace naocal {

namespace {

using Time = std::chrono::nanoseconds;

/// Readings of a joint between two times.
struct Window {
  double lowest = 0, highest = 0, mean = 0;
};

/// Absent without readings at or before `from` and at or after `to`.
std::optional<Window> windowOf(const JointSeries& series, Time from, Time to) {
  const auto isBefore = [](const auto& reading, Time time) { return reading.first < time; };
  auto begin = std::lower_bound(series.begin(), series.end(), from, isBefore);
  const auto end = std::lower_bound(begin, series.end(), to, isBefore);
  if (end == series.end() || (begin == series.begin() && begin->first > from)) {
    return std::nullopt;
  }
  if (begin->first > from) {
    --begin; // the reading that holds at `from`
  }
  Window window{begin->second, begin->second, 0};
  double sum = 0;
  for (auto reading = begin; reading <= end; ++reading) {
    window.lowest = std::min(window.lowest, reading->second);
    window.highest = std::max(window.highest, reading->second);
    sum += reading->second;
  }
  window.mean = sum / static_cast<double>(end - begin + 1);
  return window;
}

/// Mean angles if all joints rest between two times.
std::optional<std::map<std::string, double>> restAngles(const std::map<std::string, JointSeries>& joints, Time from,
                                                        Time to, double mostTravel) {
  std::map<std::string, double> angles;
  for (const auto& [name, series] : joints) {
    const std::optional<Window> window = windowOf(series, from, to);
    if (!window || window->highest - window->lowest > mostTravel) {
      return std::nullopt;
    }
    angles[name] = window->mean;
  }
  return angles;
}

bool areEqual(const std::map<std::string, double>& one, const std::map<std::string, double>& other, double most) {
  return std::equal(one.begin(), one.end(), other.begin(),
                    [&](const auto& a, const auto& b) { return std::abs(a.second - b.second) <= most; });
}

/// Gives every rest its pose and repeat.
void nameRepeats(std::vector<RestInstant>& rests, double most) {
  std::vector<std::size_t> firsts; // first rest of each pose
  std::vector<int> counts;
  for (std::size_t i = 0; i < rests.size(); ++i) {
    const auto first = std::find_if(firsts.begin(), firsts.end(),
                                    [&](std::size_t k) { return areEqual(rests[k].angles, rests[i].angles, most); });
    rests[i].pose = static_cast<std::size_t>(first - firsts.begin());
    if (first == firsts.end()) {
      firsts.push_back(i);
      counts.push_back(0);
    }
    rests[i].repeat = counts[rests[i].pose]++;
  }
}

} // namespace

std::vector<RestInstant> findRestInstants(const std::map<std::string, JointSeries>& joints,
                                          const std::vector<std::chrono::nanoseconds>& pictures,
                                          const RestOptions& options) {
  std::vector<RestInstant> rests;
  std::vector<std::size_t> together;         // pictures of the current rest
  std::map<std::string, double> firstAngles; // at the first of them
  const auto endRest = [&] {
    if (!together.empty()) {
      const std::size_t middle = together[together.size() / 2];
      const Time time = pictures[middle];
      rests.push_back(
          {middle, *restAngles(joints, time - options.around, time + options.around, options.mostTravel), 0, 0});
      together.clear();
    }
  };
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const Time from = pictures[i] - options.around, to = pictures[i] + options.around;
    const auto angles = restAngles(joints, from, to, options.mostTravel);
    if (!together.empty()) {
      const Time previous = pictures[together.back()] - options.around;
      const bool hasMoved = !restAngles(joints, previous, to, options.mostTravel);
      if (hasMoved || !areEqual(firstAngles, *angles, options.mostTravel)) { // the latter: it creeps
        endRest();
      }
    }
    if (angles) {
      if (together.empty()) {
        firstAngles = *angles;
      }
      together.push_back(i);
    }
  }
  endRest();
  nameRepeats(rests, 2 * options.mostTravel);
  return rests;
}

} // namespace naocal
