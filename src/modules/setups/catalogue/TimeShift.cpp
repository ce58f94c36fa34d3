#include "setups/Catalogue.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal {

namespace {

/// Captures that share one reading of the joints, or one pose, in the order of time: indices into the set.
using Row = std::vector<std::size_t>;

std::vector<Row> listRows(const CaptureSet& set, bool byPose) {
  std::vector<std::size_t> order(set.captures.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return set.captures[a].time < set.captures[b].time; });
  std::vector<Row> rows;
  for (const std::size_t index : order) {
    const Capture* const before = rows.empty() ? nullptr : &set.captures[rows.back().front()];
    const Capture& capture = set.captures[index];
    const bool isSame =
        before && (byPose ? before->pose == capture.pose : before->joints.measured == capture.joints.measured);
    if (!isSame) {
      rows.emplace_back();
    }
    rows.back().push_back(index);
  }
  return rows;
}

/// Gives every row the angles of the one that comes `shift` rows later, with the pose that they belong to; rows that
/// get none are left out.
void shiftRows(CaptureSet& set, int shift, bool byPose) {
  const std::vector<Row> rows = listRows(set, byPose);
  std::vector<Capture> shifted;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const auto from = static_cast<std::ptrdiff_t>(row) + shift;
    if (from < 0 || from >= std::ssize(rows)) {
      continue;
    }
    const Row& others = rows[static_cast<std::size_t>(from)];
    for (std::size_t i = 0; i < rows[row].size(); ++i) {
      Capture capture = set.captures[rows[row][i]];
      const Capture& other = set.captures[others[std::min(i, others.size() - 1)]];
      capture.joints = other.joints;
      capture.pose = other.pose;
      capture.repeat = other.repeat;
      capture.repeatKind = other.repeatKind;
      shifted.push_back(std::move(capture));
    }
  }
  set.captures = std::move(shifted);
}

bool hasRepeats(const std::vector<CaptureSet>& sets) {
  return std::any_of(sets.begin(), sets.end(),
                     [](const CaptureSet& set) { return listRows(set, true).size() < listRows(set, false).size(); });
}

} // namespace

/// The angles of a row belong to the measurement of the row before or after it: two logs were joined one row off.
SetUp timeShift() {
  return {.name = "timeShift",
          .description = "the angles belong to the measurement of the row before or after",
          .question = "Were angles and measurements written at the same instants, and joined row by row?",
          .needsNeighbours = true,
          .listPlaces =
              [](const Measurements& measurements) {
                constexpr std::size_t fewest = 4; // rows, of which one is lost
                const bool isLong = measurements.pictures.size() >= fewest;
                return isLong ? std::vector<std::string>{""} : std::vector<std::string>{};
              },
          .listMendings =
              [](const Measurements& measurements, const std::string&) {
                std::vector<Mending> ways;
                for (const int shift : {1, -1}) {
                  for (const bool byPose : {false, true}) {
                    if (byPose && !hasRepeats(*measurements.sets)) {
                      continue;
                    }
                    ways.push_back(
                        {fmt::format("the angles are shifted in time: those of one {} belong to the "
                                     "measurement of the {} {}",
                                     byPose ? "pose" : "row", byPose ? "pose" : "row", shift > 0 ? "before" : "after"),
                         [shift, byPose](Recording& recording) {
                           for (CaptureSet& set : recording.sets) {
                             shiftRows(set, shift, byPose);
                           }
                         }});
                  }
                }
                return ways;
              }};
}

} // namespace naocal
