#include "diagnose/Events.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>

namespace naocal {

namespace {

constexpr std::size_t mostMoments = 16; // per board or stance

/// From `after` on a floor placement (x, y, yaw) is another one.
Effect moved(Place place, double after) {
  Effect effect{.name = place == Place::board ? "boardMoved" : "robotMoved",
                .what = {},
                .formula = {},
                .place = place,
                .unknowns = {{"x", "m", 0.02}, {"y", "m", 0.02}, {"yaw", "rad", 0.05}},
                .correct = {}};
  effect.correct = [place, after](Belief& belief, const Instant& instant, std::size_t at,
                                  std::span<const double> values) {
    if (instant.time.count() > after) {
      auto placement = place == Place::board ? belief.boardPlacement(at) : belief.ground();
      placement[0] += values[0];
      placement[1] += values[1];
      placement[5] += values[2];
    }
  };
  return effect;
}

/// At these instants a camera looks elsewhere than it should.
Effect turned(std::string name, std::function<bool(double)> when) {
  return {.name = std::move(name),
          .what = {},
          .formula = {},
          .place = Place::camera,
          .unknowns = {{"rx", "rad", 0.02}, {"ry", "rad", 0.02}, {"rz", "rad", 0.02}},
          .correct = [when = std::move(when)](Belief& belief, const Instant& instant, std::size_t,
                                              std::span<const double> values) {
            if (when(instant.time.count())) {
              belief.mountRotation() += Eigen::Vector3d{values[0], values[1], values[2]};
            }
          }};
}

Effect bad(double time) {
  return turned("badCapture", [time](double t) { return t == time; });
}

Effect knocked(double after) {
  return turned("cameraKnocked", [after](double t) { return t > after; });
}

} // namespace

std::vector<Event> possibleEvents(const std::vector<CaptureSet>& sets, const Measurements& measurements) {
  std::vector<Event> result;
  std::map<std::size_t, std::set<double>> boards, stances, cameras;
  for (const Picture& picture : measurements.pictures) {
    const double time = picture.instant.time.count();
    bool floor = false;
    for (const Sighting& sighting : picture.sightings) {
      if (measurements.targets[sighting.view.board()].onFloor) {
        boards[sighting.view.board()].insert(time);
        floor = true;
      }
    }
    if (floor) {
      stances[picture.stance].insert(time);
    }
    if (!picture.sightings.empty()) {
      cameras[picture.camera].insert(time);
      const int id = sets[picture.set].captures[picture.capture].id;
      result.push_back({{bad(time), picture.camera, fmt::format("capture {}", id)},
                        {id},
                        fmt::format("capture {} does not belong to the rest: another picture, or other angles", id)});
    }
  }
  const auto addMoves = [&](const std::map<std::size_t, std::set<double>>& times, const auto& effect,
                            const auto& name) {
    for (const auto& [at, seen] : times) {
      for (double moment : momentsBetween(seen, mostMoments)) {
        const std::string who = name(at);
        result.push_back({{effect(moment), at, fmt::format("{} {:.3f}", who, moment)},
                          {},
                          fmt::format("{} moved {:.1f} s after the first capture", who, moment)});
      }
    }
  };
  if (boards.size() > 1) { // of one board alone it is the robot that moves
    addMoves(
        boards, [](double moment) { return moved(Place::board, moment); },
        [&](std::size_t at) { return "board " + measurements.targets[at].name; });
  }
  addMoves(
      stances, [](double moment) { return moved(Place::stance, moment); },
      [&](std::size_t at) { return "the robot in stance " + measurements.standings[at].name; });
  if (cameras.size() > 1) { // of one camera alone it may as well be the head
    addMoves(cameras, knocked, [&](std::size_t at) { return "camera " + measurements.robot.cameras[at].name; });
  }
  return result;
}

std::optional<Event> likeliestEvent(const std::vector<Event>& events, const Measurements& measurements,
                                    const Model& model, const CalibrationResult& fit, const Inquiry& inquiry) {
  std::vector<Term> terms;
  for (const Event& event : events) {
    terms.push_back(event.term);
  }
  const double level = inquiry.evidence().level;
  const Inquiry tried{measurements,
                      model,
                      fit,
                      terms,
                      {.draws = 0,
                       .map = false,
                       .levels = level > 0 ? std::vector<double>{0, level / 4, level} : std::vector<double>{0}}};
  std::size_t best = 0;
  for (std::size_t i = 1; i < events.size(); ++i) {
    if (tried.ofCandidate(i).bayes > tried.ofCandidate(best).bayes) {
      best = i;
    }
  }
  double effects = 0;
  for (const GroupEvidence& group : inquiry.evidence().groups) {
    effects = std::max(effects, group.bayes);
  }
  const double chance = 10 + 2 * std::log(static_cast<double>(events.size()));
  return tried.ofCandidate(best).bayes > effects + chance ? std::optional{events[best]} : std::nullopt;
}

} // namespace naocal
