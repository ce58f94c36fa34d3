#include "setups/Mending.hpp"

#include "estimation/ModelBuilder.hpp"
#include "io/InputError.hpp"
#include "setups/Catalogue.hpp"
#include "setups/LeftOut.hpp"
#include "setups/SetUpFit.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <limits>
#include <utility>

namespace naocal {

namespace {

/// A label's parts.
struct Label {
  const SetUp* setUp = nullptr; // null: none of the catalogue
  std::string place;
};

Label parseLabel(const std::string& label) {
  const std::size_t at = std::min(label.find('@'), label.size());
  const std::vector<SetUp>& all = allSetUps();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const SetUp& one) { return label.compare(0, at, one.name) == 0; });
  return {found == all.end() ? nullptr : &*found, label.substr(std::min(at + 1, label.size()))};
}

/// Whether the sets list all joints of a place, although these captures may learn nothing of them.
bool areJoints(const std::string& place, const std::vector<CaptureSet>& sets) {
  const std::vector<std::string>& names = sets.front().jointNames;
  std::size_t first = 0;
  for (std::size_t end = 0; end != std::string::npos; first = end + 1) {
    end = place.find(',', first);
    if (std::find(names.begin(), names.end(), place.substr(first, end - first)) == names.end()) {
      return false;
    }
  }
  return true;
}

/// The ways to undo a mistake. Throws InputError if these captures cannot have it.
std::vector<Mending> listWays(const std::string& label, const Measurements& measurements) {
  const auto [setUp, place] = parseLabel(label);
  const std::vector<std::string> places = setUp->listPlaces(measurements);
  const bool isPlace = std::find(places.begin(), places.end(), place) != places.end();
  if (isPlace || (setUp->needs.empty() && areJoints(place, *measurements.sets))) {
    std::vector<Mending> ways = setUp->listMendings(measurements, place);
    if (!ways.empty()) {
      return ways;
    }
  }
  if (places.empty() && !setUp->needs.empty()) {
    throw InputError{fmt::format("'{}' needs {}, found none", label, setUp->needs)};
  }
  throw InputError{fmt::format("'{}' names no place of these captures where that could be; near it are {}", label,
                               fmt::join(closestNames(place, places), ", "))};
}

/// What a fit of captures leaves after one way to undo a mistake [2 ln].
double lengthAfter(const Mending& way, const Recording& recording) {
  Recording mended = recording;
  way.apply(mended);
  try {
    const Measurements measurements = buildMeasurements(std::move(mended.sets), mended.robot);
    const auto left = fitAnew(measurements, buildModel(measurements), {});
    return left ? left->length : std::numeric_limits<double>::infinity();
  } catch (const InputError&) {
    return std::numeric_limits<double>::infinity();
  }
}

void mend(const std::string& label, Recording& recording) {
  const std::vector<Mending> ways = listWays(label, buildMeasurements(recording.sets, recording.robot));
  const Mending* best = &ways.front();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ways.size() && ways.size() > 1; ++i) {
    const double length = lengthAfter(ways[i], recording);
    if (length < least) {
      least = length;
      best = &ways[i];
    }
  }
  best->apply(recording);
}

} // namespace

bool isSetUp(const std::string& label) {
  return isLeftOut(label) || parseLabel(label).setUp != nullptr;
}

std::vector<std::string> joinLabels(const std::vector<std::string>& pieces) {
  std::vector<std::string> labels;
  for (const std::string& piece : pieces) {
    if (labels.empty() || piece.find('@') != std::string::npos || isSetUp(piece) || !isSetUp(labels.back())) {
      labels.push_back(piece);
    } else {
      labels.back() += ',' + piece;
    }
  }
  return labels;
}

std::vector<std::string> mendSetUps(std::vector<std::string>& with, Robot& robot, std::vector<CaptureSet>& sets) {
  std::vector<std::string> rest, mended;
  std::partition_copy(with.begin(), with.end(), std::back_inserter(mended), std::back_inserter(rest), isSetUp);
  if (mended.empty()) {
    return {};
  }
  Recording recording{sets, robot};
  const auto first = std::stable_partition(mended.begin(), mended.end(), isLeftOut);
  std::for_each(mended.begin(), first, [&](const std::string& label) { leaveOut(label, recording.sets); });
  std::for_each(first, mended.end(), [&](const std::string& label) { mend(label, recording); });
  sets = std::move(recording.sets);
  robot = std::move(recording.robot);
  with = std::move(rest);
  return mended;
}

} // namespace naocal
