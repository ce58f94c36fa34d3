#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Time of an event within one set, relative to the first capture.
struct Moment {
  std::size_t set = 0;
  double time = 0;             // most likely time [s]
  double since = 0, until = 0; // certain bounds [s]
};

/// Estimate of one unknown of an event.
struct EventValue {
  std::string unknown, unit;
  double value = 0, sigma = 0; // [unit]
  double low = 0, high = 0;    // 95 % interval
};

/// A suspicious capture, board or setting.
struct DataAnomaly {
  std::optional<int> capture; // id of the capture, if one is concerned
  std::string why;
  std::size_t set = 0;                 // set of the capture
  std::optional<double> odds = {};     // odds (x to 1) against the best effect or curve, where compared
  std::optional<Moment> when = {};     // moment of an event between two captures
  std::string setUp = {};              // a wrong set-up, which can be mended: "reversedJoint@LElbowRoll"
  std::string question = {};           // about the set-up, to ask a person
  std::string moved = {};              // id of the board, tracker, camera or stance that moved; with `capture`, of the
                                       // board that was displaced in it
  bool isFurther = false;              // a capture that was taken with the one before, which tells why
  std::optional<int> from = {};        // id of the first capture after that
  std::vector<EventValue> values = {}; // estimates, where the size of an event was estimated
};

} // namespace naocal
