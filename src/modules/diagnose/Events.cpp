#include "diagnose/Events.hpp"

#include "evidence/ModelAlone.hpp"
#include "evidence/NoiseLevels.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <set>

namespace naocal {

namespace {

/// Sets follow each other in the order in which they were given.
bool isAfter(const Instant& instant, const Moment& moment) {
  return instant.set > moment.set || (instant.set == moment.set && instant.time.count() > moment.time);
}

/// From a moment on a floor placement (x, y, yaw) is another one.
Effect moved(Place place, const Moment& moment) {
  Effect effect{.name = place == Place::board ? "boardMoved" : "robotMoved",
                .what = {},
                .formula = {},
                .place = place,
                .unknowns = {{"x", "m", 0.02}, {"y", "m", 0.02}, {"yaw", "rad", 0.05}},
                .correct = {}};
  effect.correct = [place, moment](Belief& belief, const Instant& instant, std::size_t at,
                                   std::span<const double> values) {
    if (isAfter(instant, moment)) {
      auto placement = place == Place::board ? belief.boardPlacement(at) : belief.ground();
      placement[0] += values[0];
      placement[1] += values[1];
      placement[5] += values[2];
    }
  };
  return effect;
}

/// At these instants a camera looks elsewhere than it should.
Effect turned(std::string name, std::function<bool(const Instant&)> when) {
  return {.name = std::move(name),
          .what = {},
          .formula = {},
          .place = Place::camera,
          .unknowns = {{"rx", "rad", 0.02}, {"ry", "rad", 0.02}, {"rz", "rad", 0.02}},
          .correct = [when = std::move(when)](Belief& belief, const Instant& instant, std::size_t,
                                              std::span<const double> values) {
            if (when(instant)) {
              belief.mountRotation() += Eigen::Vector3d{values[0], values[1], values[2]};
            }
          }};
}

Effect bad(const Moment& moment) {
  return turned("badCapture", [moment](const Instant& instant) {
    return instant.set == moment.set && instant.time.count() == moment.time;
  });
}

Effect knocked(const Moment& moment) {
  return turned("cameraKnocked", [moment](const Instant& instant) { return isAfter(instant, moment); });
}

/// A single bad pose makes all poses seem to scatter: without it they would scatter less.
std::vector<Noise> levelsBelow(const Noise& noise) {
  std::vector<Noise> result{noise};
  if (noise.pose + noise.reapproach > 0) {
    for (const double part : {0.0, 0.25, 0.5}) {
      Noise& less = result.emplace_back(noise);
      less.pose *= part;
      less.reapproach *= part;
    }
  }
  return result;
}

/// Per group, its Bayes factor where the level of noise suits it best, against the model at the first level.
std::vector<double> bestAtAny(const ScoreProblem& problem, const std::vector<Noise>& levels) {
  std::vector<double> result(problem.groups.size(), -std::numeric_limits<double>::infinity());
  double first = 0;
  const PoseResiduals measured = measuredResiduals(*problem.poses);
  for (const Noise& level : levels) {
    const double deviance = ModelAlone{problem, level}(measured, problem.priorScore()).deviance[0] +
                            scatterPenalty(level.pose) + scatterPenalty(level.reapproach);
    first = &level == levels.data() ? deviance : first;
    const Evidence evidence = evidenceOf(problem, level);
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] = std::max(result[i], evidence.groups[i].bayes - (deviance - first));
    }
  }
  return result;
}

/// When boards, stances or cameras were seen, by set and number.
using Times = std::map<std::pair<std::size_t, std::size_t>, std::set<double>>;

std::string inSet(std::size_t set, const std::vector<CaptureSet>& sets) {
  return sets.size() > 1 ? " of " + sets[set].name : std::string{};
}

/// Whether there are several of them in the set.
bool severalIn(std::size_t set, const Times& times) {
  const auto ofSet = [set](const auto& entry) { return entry.first.first == set; };
  return std::count_if(times.begin(), times.end(), ofSet) > 1;
}

/// Boards, stances and cameras, each moved at this many moments at most.
std::vector<Event> movesAt(std::size_t most, const std::vector<CaptureSet>& sets, const Measurements& measurements) {
  std::vector<Event> result;
  Times boards, stances, cameras;
  for (const Picture& picture : measurements.pictures) {
    const double time = picture.instant.time.count();
    for (const Sighting& sighting : picture.sightings) {
      if (measurements.targets[sighting.view.board()].onFloor) {
        boards[{picture.set, sighting.view.board()}].insert(time);
        stances[{picture.set, picture.stance}].insert(time);
      }
      cameras[{picture.set, picture.camera}].insert(time);
    }
  }
  const auto addMoves = [&](const Times& times, const auto& effect, const auto& name) {
    for (const auto& [which, seen] : times) {
      const auto& [set, at] = which;
      for (const double time : momentsBetween(seen, most)) {
        const std::string who = name(at), where = inSet(set, sets);
        result.push_back({{effect(Moment{set, time}), at, fmt::format("{} {:.3f}{}", who, time, where)},
                          Moment{set, time},
                          {},
                          fmt::format("{} moved {:.1f} s after the first capture{}", who, time, where)});
      }
    }
  };
  Times movable = boards, knockable = cameras;
  // of one board alone it is the robot that moves, of one camera alone it may as well be the head
  std::erase_if(movable, [&](const auto& entry) { return !severalIn(entry.first.first, boards); });
  std::erase_if(knockable, [&](const auto& entry) { return !severalIn(entry.first.first, cameras); });
  addMoves(
      movable, [](const Moment& moment) { return moved(Place::board, moment); },
      [&](std::size_t at) { return "board " + measurements.targets[at].name; });
  addMoves(
      stances, [](const Moment& moment) { return moved(Place::stance, moment); },
      [&](std::size_t at) { return "the robot in stance " + measurements.standings[at].name; });
  addMoves(knockable, knocked, [&](std::size_t at) { return "camera " + measurements.robot.cameras[at].name; });
  return result;
}

/// Pictures in which something was seen; of more than `most` those with the largest errors.
std::vector<std::size_t> worstPictures(std::size_t most, const Measurements& measurements,
                                       const CalibrationResult& fit) {
  std::vector<double> squares(measurements.pictures.size(), 0), corners = squares;
  for (const SightingResidual& sighting : fit.asReported) {
    squares[sighting.picture] += sighting.residual.squaredNorm();
    corners[sighting.picture] += static_cast<double>(sighting.residual.cols());
  }
  std::vector<std::size_t> result;
  for (std::size_t picture = 0; picture < corners.size(); ++picture) {
    if (corners[picture] > 0) {
      result.push_back(picture);
    }
  }
  if (result.size() > most) {
    const auto worse = [&](std::size_t a, std::size_t b) { return squares[a] * corners[b] > squares[b] * corners[a]; };
    std::nth_element(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(most), result.end(), worse);
    result.resize(most);
    std::sort(result.begin(), result.end());
  }
  return result;
}

} // namespace

std::vector<Event> possibleEvents(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                                  const CalibrationResult& fit) {
  constexpr std::size_t most = 16; // per board, stance or camera
  constexpr std::size_t mostPictures = 128;
  std::vector<Event> result = movesAt(most, sets, measurements);
  for (const std::size_t index : worstPictures(mostPictures, measurements, fit)) {
    const Picture& picture = measurements.pictures[index];
    const int id = sets[picture.set].captures[picture.capture].id;
    const std::string name = fmt::format("capture {}{}", id, inSet(picture.set, sets));
    result.push_back({{bad({picture.set, picture.instant.time.count()}), picture.camera, name},
                      {},
                      {id},
                      name + " does not belong to the rest: another picture, or other angles"});
  }
  return result;
}

std::vector<Event> atAnyTime(const Event& event, const std::vector<CaptureSet>& sets,
                             const Measurements& measurements) {
  constexpr std::size_t most = 128;
  std::vector<Event> result = movesAt(most, sets, measurements);
  std::erase_if(result, [&](const Event& other) {
    return other.from->set != event.from->set || other.term.at != event.term.at ||
           other.term.effect.name != event.term.effect.name;
  });
  return result;
}

std::optional<LikelyEvent> likeliestEvent(const std::vector<Event>& events, const Measurements& measurements,
                                          const Model& model, const CalibrationResult& fit, const Inquiry& inquiry) {
  std::vector<Term> terms;
  for (const Event& event : events) {
    terms.push_back(event.term);
  }
  const Inquiry tried{measurements, model, fit, terms, {.draws = 0, .map = false}};
  const std::vector<Noise> levels = levelsBelow(inquiry.noise());
  const std::vector<double> likely = bestAtAny(tried.problem(), levels), effects = bestAtAny(inquiry.problem(), levels);
  const auto best = static_cast<std::size_t>(std::max_element(likely.begin(), likely.end()) - likely.begin());
  const std::size_t possible = std::max(events.size(), measurements.pictures.size()); // also what is not worth a look
  const double chance = 10 + 2 * std::log(static_cast<double>(possible));
  const double most = effects.empty() ? 0 : std::max(0.0, *std::max_element(effects.begin(), effects.end()));
  constexpr double notable = 0.1; // [px]: a tenth of a millimetre at arm's length; less is a detector's own bias
  const GroupEvidence& found = tried.ofCandidate(best);
  const bool matters = events[best].captures.empty() ? found.movedPx > notable : found.matters();
  if (likely[best] <= most + chance || !matters) {
    return std::nullopt;
  }
  constexpr double mostOdds = 1e12;
  return LikelyEvent{events[best], std::min(mostOdds, std::exp((likely[best] - most) / 2))};
}

} // namespace naocal
