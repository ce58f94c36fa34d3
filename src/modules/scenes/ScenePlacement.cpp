#include "scenes/ScenePlacement.hpp"

#include "math/Sampling.hpp"

#include <optional>
#include <string>

namespace naocal {

namespace {

class ScenePlacement {
public:
  ScenePlacement(const RobotScene& scene, const ScenePlan& plan)
      : scene_{scene}, spread_{plan.spread}, chance_{plan.sceneSeed.value_or(plan.seed), "scene"} {}

  CaptureSet set();

private:
  Placement draw(const std::string& name, const std::optional<Placement>& given, const std::optional<Placement>& guess,
                 bool isFlat);
  Placement spread(Placement placement, bool isFlat);
  Eigen::Vector3d drawPoint(const std::string& name, const Eigen::Vector3d& guess);

  const RobotScene& scene_;
  double spread_;
  RandomStream chance_;
};

CaptureSet ScenePlacement::set() {
  CaptureSet placed = scene_.set;
  for (Board& board : placed.boards) {
    const auto guess = board.hasGuess ? std::optional{board.placementGuess} : std::nullopt;
    board.placement = draw("boards." + board.id, board.placement, guess, board.link == "floor");
    board.hasGuess = false;
  }
  for (auto& [name, mounting] : placed.mountings) {
    if (mounting.link == "world") {
      mounting.placement = draw("cameras." + name, mounting.placement, mounting.guess, false);
    }
  }
  for (Tracker& tracker : placed.instruments.trackers) {
    tracker.placement = draw("trackers." + tracker.id, tracker.placement, std::nullopt, false);
  }
  for (TrackedFrame& frame : placed.instruments.frames) {
    frame.placement = draw("frames." + frame.id, frame.placement, Placement{}, false);
  }
  for (TrackedMarker& marker : placed.instruments.markers) {
    marker.point = marker.point ? *marker.point : drawPoint("markers." + marker.id, marker.pointGuess);
  }
  for (ContactPlace& place : placed.instruments.places) {
    place.point = place.point ? *place.point : drawPoint("places." + place.id, Eigen::Vector3d::Zero());
  }
  placed.instruments.distances.clear(); // they follow from the places
  Stance& stance = placed.stances.front();
  if (standsOnSole(scene_.set) && !stance.placement) {
    stance.placement = spread({}, true);
  }
  return placed;
}

Placement ScenePlacement::draw(const std::string& name, const std::optional<Placement>& given,
                               const std::optional<Placement>& guess, bool isFlat) {
  const auto about = scene_.about.find(name);
  return given ? *given : spread(about == scene_.about.end() ? guess.value() : about->second, isFlat);
}

Placement ScenePlacement::spread(Placement placement, bool isFlat) {
  const double shift = 0.03 * spread_, turn = 0.1 * spread_; // [m], [rad]
  for (double Placement::*const value : {&Placement::x, &Placement::y, &Placement::z}) {
    placement.*value += isFlat && value == &Placement::z ? 0 : chance_.uniformWithin(shift);
  }
  for (double Placement::*const value : {&Placement::roll, &Placement::pitch, &Placement::yaw}) {
    placement.*value += isFlat && value != &Placement::yaw ? 0 : chance_.uniformWithin(turn);
  }
  return placement;
}

Eigen::Vector3d ScenePlacement::drawPoint(const std::string& name, const Eigen::Vector3d& guess) {
  const double shift = 0.01 * spread_; // [m]
  const auto about = scene_.about.find(name);
  Eigen::Vector3d point = guess;
  if (about != scene_.about.end()) {
    point = {about->second.x, about->second.y, about->second.z};
  }
  for (double& coordinate : point) {
    coordinate += chance_.uniformWithin(shift);
  }
  return point;
}

} // namespace

CaptureSet placeScene(const RobotScene& scene, const ScenePlan& plan) {
  return ScenePlacement{scene, plan}.set();
}

} // namespace naocal
