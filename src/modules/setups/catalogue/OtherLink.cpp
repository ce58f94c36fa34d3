#include "setups/Catalogue.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace naocal {

namespace {

/// The link that stands for all that are fixed to this one: the nearest to the root.
std::size_t bodyOf(const Robot& robot, std::size_t link) {
  while (!robot.links[link].joint && robot.links[link].parent) {
    link = *robot.links[link].parent;
  }
  return link;
}

/// The links on the other side of a joint of these.
std::set<std::size_t> linksBeyond(const Robot& robot, const std::set<std::size_t>& bodies) {
  std::set<std::size_t> result;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    if (robot.links[link].joint && robot.links[link].parent) {
      const std::size_t parent = bodyOf(robot, *robot.links[link].parent);
      if (bodies.contains(link)) {
        result.insert(parent);
      }
      if (bodies.contains(parent)) {
        result.insert(link);
      }
    }
  }
  return result;
}

/// The links that one joint or two divide from this one.
std::set<std::size_t> neighboursOf(const Robot& robot, std::size_t link) {
  const std::size_t body = bodyOf(robot, link);
  std::set<std::size_t> result = linksBeyond(robot, {body});
  result.merge(linksBeyond(robot, result));
  result.erase(body);
  return result;
}

/// Calls `change` with every marker and frame of this name, or of those on this link, whose place is to be estimated.
template <typename Sets, typename Change>
void eachEstimated(Sets& sets, const std::string& place, const Change& change) {
  for (auto& set : sets) {
    for (auto& marker : set.instruments.markers) {
      if ((marker.id == place || marker.link == place) && !marker.point) {
        change(marker);
      }
    }
    for (auto& frame : set.instruments.frames) {
      if ((frame.id == place || frame.link == place) && !frame.placement) {
        change(frame);
      }
    }
  }
}

/// Puts a marker or frame on another link, on which nothing is known of its place.
struct MoveTo {
  std::string link;

  void operator()(TrackedMarker& marker) const {
    constexpr double anywhere = 0.5; // [m]
    marker.link = link;
    marker.pointGuess.setZero();
    marker.pointSigma = std::max(marker.pointSigma, anywhere);
  }
  void operator()(TrackedFrame& frame) const { frame.link = link; }
};

/// The names of markers and frames whose place is to be estimated, by link.
std::map<std::string, std::set<std::string>> listByLink(const std::vector<CaptureSet>& sets) {
  std::map<std::string, std::set<std::string>> names;
  for (const CaptureSet& set : sets) {
    for (const TrackedMarker& marker : set.instruments.markers) {
      if (!marker.point) {
        names[marker.link].insert(marker.id);
      }
    }
    for (const TrackedFrame& frame : set.instruments.frames) {
      if (!frame.placement) {
        names[frame.link].insert(frame.id);
      }
    }
  }
  return names;
}

/// "m"; and "hand" for all on that link, where these are several.
std::vector<std::string> listPlaces(const Measurements& measurements) {
  std::vector<std::string> places;
  for (const auto& [link, names] : listByLink(*measurements.sets)) {
    places.insert(places.end(), names.begin(), names.end());
    if (names.size() > 1) {
      places.push_back(link);
    }
  }
  return places;
}

std::vector<Mending> listMendings(const Measurements& measurements, const std::string& place) {
  const Robot& robot = measurements.robot;
  std::string named;
  eachEstimated(*measurements.sets, place, [&](const auto& one) { named = one.link; });
  const auto link = robot.linkIndex(named);
  std::vector<Mending> ways;
  for (const std::size_t other : link ? neighboursOf(robot, *link) : std::set<std::size_t>{}) {
    const std::string& name = robot.links[other].name;
    ways.push_back({place == named ? fmt::format("what is measured on {} sits on {}", named, name)
                                   : fmt::format("{} sits on {}, not on {}", place, name, named),
                    [place, name](Recording& recording) { eachEstimated(recording.sets, place, MoveTo{name}); }});
  }
  return ways;
}

} // namespace

/// What a tracker measures, or what touches places, sits on another link, up to two joints away: a flange that does not
/// turn with the last joint, or a link that was guessed. Only where its place on its link is to be estimated.
SetUp otherLink() {
  return {.name = "otherLink",
          .description = "the marker or frame sits on another link than the one that the file names",
          .question = "Which joint is the last one that moves {}?",
          .listPlaces = listPlaces,
          .listMendings = listMendings};
}

} // namespace naocal
