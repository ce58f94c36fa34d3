#pragma once

#include <chrono>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

/// Readings of one joint in ascending order of time [rad], [m].
using JointSeries = std::vector<std::pair<std::chrono::nanoseconds, double>>;

/// When joints count as resting.
struct RestOptions {
  double mostTravel = 0.004; // largest minus smallest reading; two steps of a 12-bit encoder are 0.003 [rad], [m]
  std::chrono::nanoseconds around = std::chrono::milliseconds{250}; // before and after the instant
};

/// An instant at which all joints rest, with one picture.
struct RestInstant {
  std::size_t picture = 0;              // index into the times of pictures
  std::map<std::string, double> angles; // mean over the window, by joint [rad], [m]
  std::size_t pose = 0;                 // rests at equal angles share it
  int repeat = 0;                       // within the pose
};

/// One instant for each rest between two motions: that of the middle picture during which all joints rest. A picture
/// counts if every joint has readings up to `around` before and after it whose range is at most `mostTravel`. Rests
/// whose joints all lie within twice `mostTravel` of an earlier rest are repeats of its pose.
std::vector<RestInstant> findRestInstants(const std::map<std::string, JointSeries>& joints,
                                          const std::vector<std::chrono::nanoseconds>& pictures,
                                          const RestOptions& options);

} // namespace naocal
