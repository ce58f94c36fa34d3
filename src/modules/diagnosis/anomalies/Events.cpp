#include "diagnosis/anomalies/Events.hpp"

#include "calibration/BoardMoves.hpp"
#include "calibration/Fit.hpp"
#include "calibration/Uncertainty.hpp"
#include "estimation/EffectJacobian.hpp"
#include "estimation/Model.hpp"
#include "inference/DriverBasis.hpp"
#include "inference/Thresholds.hpp"
#include "io/InputError.hpp"
#include "io/Units.hpp"
#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"
#include "measurements/Measurements.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace naocal {

namespace {

/// Fits first without downweighting, since displaced corners have lost their weight.
FitMinimum fitFrom(const Eigen::VectorXd& start, const FittedModel& fitted) {
  Fit full = fitForComparison(fitted.measurements, fitted.model, fitted.fit.noise, Loss{}, start);
  return refit(fitted.measurements, fitted.model, fitted.fit.noise, fitted.fit.loss, std::move(full),
               comparisonTolerance)
      .minimum;
}

constexpr double millimetres = 1000; // per metre

/// Sets are in chronological order.
bool isAfter(const RobotSample& instant, const Moment& moment) {
  return instant.set > moment.set || (instant.set == moment.set && instant.time.count() > moment.time);
}

/// Displacement of a floor placement (x, y, yaw) from a moment on.
Effect makeMove(PlaceKind place, const Moment& moment) {
  Effect effect{.name = place == PlaceKind::board ? "boardMoved" : "robotMoved",
                .description = {},
                .formula = {},
                .placeKind = place,
                .unknowns = {{"x", "m", 0.02}, {"y", "m", 0.02}, {"yaw", "rad", 0.05}},
                .correct = {}};
  effect.correct = [place, moment](ModelState& modelState, const RobotSample& instant, std::size_t at,
                                   std::span<const double> values) {
    if (isAfter(instant, moment)) {
      auto placement = place == PlaceKind::board ? modelState.boardPlacement(at) : modelState.worldFromSupport();
      placement[0] += values[0];
      placement[1] += values[1];
      placement[5] += values[2];
    }
  };
  return effect;
}

/// Displacement of something that stands anyhow from a moment on: a board in the world, a camera beside the robot, a
/// tracker.
Effect makeMoveAnyhow(PlaceKind place, const Moment& moment) {
  Effect effect{.name = place == PlaceKind::board    ? "boardMoved"
                        : place == PlaceKind::camera ? "cameraMoved"
                                                     : "trackerMoved",
                .description = {},
                .formula = {},
                .placeKind = place,
                .unknowns = {{"x", "m", 0.02},
                             {"y", "m", 0.02},
                             {"z", "m", 0.02},
                             {"rx", "rad", 0.05},
                             {"ry", "rad", 0.05},
                             {"rz", "rad", 0.05}},
                .correct = {}};
  effect.correct = [place, moment](ModelState& modelState, const RobotSample& instant, std::size_t at,
                                   std::span<const double> values) {
    if (!isAfter(instant, moment)) {
      return;
    }
    const StateLayout& layout = modelState.layout();
    const std::size_t first = place == PlaceKind::board    ? layout.board(at)
                              : place == PlaceKind::camera ? layout.mountTranslation()
                                                           : layout.tracker(at);
    for (std::size_t i = 0; i < values.size(); ++i) {
      modelState.values[static_cast<Eigen::Index>(first + i)] += values[i];
    }
  };
  return effect;
}

/// Camera rotation at the selected instants.
Effect makeTurn(std::string name, std::function<bool(const RobotSample&)> when) {
  return {.name = std::move(name),
          .description = {},
          .formula = {},
          .placeKind = PlaceKind::camera,
          .unknowns = {{"rx", "rad", 0.02}, {"ry", "rad", 0.02}, {"rz", "rad", 0.02}},
          .correct = [when = std::move(when)](ModelState& modelState, const RobotSample& instant, std::size_t,
                                              std::span<const double> values) {
            if (when(instant)) {
              modelState.mountRotation() += Eigen::Vector3d{values[0], values[1], values[2]};
            }
          }};
}

Effect makeBadPose(const Moment& moment) {
  return makeTurn("badCapture", [moment](const RobotSample& instant) {
    return instant.set == moment.set && instant.time.count() == moment.time;
  });
}

Effect makeKnock(const Moment& moment) {
  return makeTurn("cameraKnocked", [moment](const RobotSample& instant) { return isAfter(instant, moment); });
}

/// Step of a joint reading from a moment on: slipped gear or encoder.
Effect makeStep(const Moment& moment) {
  return {.name = "jointStepped",
          .description = {},
          .formula = {},
          .placeKind = PlaceKind::motor,
          .unknowns = {{"step", "rad", 0.01}},
          .correct = [moment](ModelState& modelState, const RobotSample& instant, std::size_t joint,
                              std::span<const double> values) {
            if (isAfter(instant, moment)) {
              modelState.angle(joint) -= values[0];
            }
          }};
}

/// Observation times of boards, stances or cameras, by (set, index).
using Times = std::map<std::pair<std::size_t, std::size_t>, std::set<double>>;

/// The moment at `time`, bounded by the neighbouring observation times.
Moment momentIn(std::size_t set, const std::set<double>& times, double time) {
  const auto after = times.upper_bound(time);
  return {set, time, *std::prev(after), *after};
}

/// Prior of a moment: 2 ln of its gap's length relative to the mean of `count` gaps as long as these together.
double priorOf(const Moment& moment, const std::vector<TimeGap>& gaps, std::size_t count) {
  const double whole = std::accumulate(gaps.begin(), gaps.end(), 0.0,
                                       [](double sum, const TimeGap& gap) { return sum + gap.second - gap.first; });
  return 2 * std::log(static_cast<double>(count) * (moment.until - moment.since) / whole);
}

std::string formatSet(std::size_t set, const Measurements& measurements) {
  const std::vector<CaptureSet>& sets = *measurements.sets;
  return sets.size() > 1 ? " of " + sets[set].name : std::string{};
}

/// How many of them a set contains.
std::ptrdiff_t countIn(const Times& all, std::size_t set) {
  return std::count_if(all.begin(), all.end(), [&](const auto& other) { return other.first.first == set; });
}

/// The times in sets that contain several of them.
Times ofSeveral(const Times& all) {
  Times result = all;
  std::erase_if(result, [&](const auto& entry) { return countIn(all, entry.first.first) <= 1; });
  return result;
}

/// The times of `some` in sets that do not contain a single one of `others`.
Times unlessSingle(const Times& some, const Times& others) {
  Times result = some;
  std::erase_if(result, [&](const auto& entry) { return countIn(others, entry.first.first) == 1; });
  return result;
}

/// Observation times of everything that may be displaced; joints by their motors.
struct Sightings {
  Times boards, stances, cameras, joints;
  Times freeBoards, camerasBeside, trackers; // that stand anyhow
};

Sightings collectSightings(const Measurements& measurements) {
  Sightings result;
  for (const ImageObservation& picture : measurements.pictures) {
    const double time = picture.instant.time.count();
    for (const BoardObservation& observation : picture.observations) {
      const Target& target = measurements.targets[observation.view.board()];
      if (target.inWorld) {
        (target.isFlat ? result.boards : result.freeBoards)[{picture.set, observation.view.board()}].insert(time);
      }
      if (target.isFlat) {
        result.stances[{picture.set, picture.stance}].insert(time);
      }
      const bool standsBeside = measurements.robot.cameras[picture.camera].inWorld;
      (standsBeside ? result.camerasBeside : result.cameras)[{picture.set, picture.camera}].insert(time);
    }
    for (const WitnessObservation& observation : picture.witnesses) {
      const std::vector<std::size_t>& own = observation.witness->own();
      for (std::size_t tracker = 0; tracker < measurements.instruments.trackers.size(); ++tracker) {
        if (std::find(own.begin(), own.end(), measurements.quantities.tracker(tracker)) != own.end()) {
          result.trackers[{picture.set, tracker}].insert(time);
        }
      }
    }
    for (const std::size_t joint :
         picture.measuresNothing() ? std::vector<std::size_t>{} : observedJoints(measurements.robot, picture)) {
      result.joints[{picture.set, measurements.robot.joints[joint].motor}].insert(time);
    }
  }
  return result;
}

/// Per set, the times of the captures before which the robot went to another pose or stance.
std::vector<std::set<double>> collectStarts(const Measurements& measurements) {
  std::vector<std::map<double, const Capture*>> captures(measurements.sets->size());
  for (const ImageObservation& picture : measurements.pictures) {
    captures[picture.set][picture.instant.time.count()] = &measurements.captureOf(picture);
  }
  std::vector<std::set<double>> result;
  for (const std::map<double, const Capture*>& ofSet : captures) {
    std::set<double>& starts = result.emplace_back();
    const Capture* before = nullptr;
    for (const auto& [time, capture] : ofSet) {
      if (before == nullptr || before->pose != capture->pose || before->stance != capture->stance) {
        starts.insert(time);
      }
      before = capture;
    }
  }
  return result;
}

/// Gaps between sightings in which to look for at most `most` moments. If there are more, those between poses come
/// first, then the widest: at a moment among captures of one pose, half of these speak against all that happened
/// shortly before or after.
std::vector<TimeGap> chooseGaps(const std::set<double>& seen, const std::set<double>& starts, std::size_t most) {
  std::vector<TimeGap> gaps = gapsBetween(seen);
  const auto isBetweenPoses = [&](const TimeGap& gap) {
    const auto start = starts.upper_bound(gap.first);
    return start != starts.end() && *start <= gap.second;
  };
  const auto width = [](const TimeGap& gap) { return gap.second - gap.first; };
  const auto within = std::stable_partition(gaps.begin(), gaps.end(), isBetweenPoses);
  std::stable_sort(within, gaps.end(), [&](const TimeGap& a, const TimeGap& b) { return width(a) > width(b); });
  const auto between = static_cast<std::size_t>(within - gaps.begin());
  gaps.resize(std::min(gaps.size(), std::max(between, most)));
  std::sort(gaps.begin(), gaps.end());
  return gaps;
}

/// Displacements of boards, stances, cameras and joint zeros, at up to `most` moments each.
std::vector<TransientEvent> movesAt(std::size_t most, const Measurements& measurements) {
  std::vector<TransientEvent> result;
  const std::vector<std::set<double>> starts = collectStarts(measurements);
  const auto addMoves = [&](const Times& times, const auto& effect, const auto& name, const auto& idOf) {
    for (const auto& [which, seen] : times) {
      const auto& [set, at] = which;
      const std::vector<TimeGap> gaps = chooseGaps(seen, starts[set], most);
      const std::vector<double> moments = midpointsOf(gaps, most);
      for (const double time : moments) {
        const Moment moment = momentIn(set, seen, time);
        const std::string who = name(at), where = formatSet(set, measurements);
        result.push_back({.term = {effect(moment), at, fmt::format("{} {:.3f}{}", who, time, where)},
                          .from = moment,
                          .who = who,
                          .where = where,
                          .moved = idOf(at),
                          .set = set,
                          .prior = priorOf(moment, gaps, moments.size())});
      }
    }
  };
  const Sightings all = collectSightings(measurements);
  // on one foot before a single board, the board may have moved or the robot; a single camera's turn is the head's
  const auto targetId = [&](std::size_t at) { return measurements.targets[at].name; };
  const auto cameraId = [&](std::size_t at) { return measurements.robot.cameras[at].name; };
  const auto trackerId = [&](std::size_t at) { return measurements.instruments.trackers[at].name; };
  const auto named = [](const char* kind, const auto& idOf) {
    return [kind, &idOf](std::size_t at) { return kind + idOf(at); };
  };
  const auto moveAnyhow = [](PlaceKind place) {
    return [place](const Moment& moment) { return makeMoveAnyhow(place, moment); };
  };
  const auto isSingle = [&](std::size_t at) {
    return std::any_of(all.boards.begin(), all.boards.end(), [&](const auto& entry) {
      return entry.first.second == at && countIn(all.boards, entry.first.first) == 1;
    });
  };
  addMoves(
      all.boards, [](const Moment& moment) { return makeMove(PlaceKind::board, moment); },
      [&](std::size_t at) { return "board " + targetId(at) + (isSingle(at) ? " (or the robot)" : ""); }, targetId);
  addMoves(
      unlessSingle(all.stances, all.boards), [](const Moment& moment) { return makeMove(PlaceKind::stance, moment); },
      [&](std::size_t at) { return "the robot in stance " + measurements.stances[at].name; },
      [&](std::size_t at) { return measurements.stances[at].name; });
  addMoves(ofSeveral(all.cameras), makeKnock, named("camera ", cameraId), cameraId);
  addMoves(
      all.joints, makeStep, [&](std::size_t at) { return measurements.robot.joints[at].name; },
      [](std::size_t) { return std::string{}; });
  addMoves(all.freeBoards, moveAnyhow(PlaceKind::board), named("board ", targetId), targetId);
  addMoves(all.camerasBeside, moveAnyhow(PlaceKind::camera), named("camera ", cameraId), cameraId);
  addMoves(all.trackers, moveAnyhow(PlaceKind::tracker), named("tracker ", trackerId), trackerId);
  return result;
}

/// Pictures with corners; at most `most`, those with the largest errors.
std::vector<std::size_t> worstPictures(std::size_t most, const Measurements& measurements,
                                       const CalibrationResult& fit) {
  std::vector<double> squares(measurements.pictures.size(), 0), corners = squares;
  for (const BoardResidual& observation : fit.withReportedAngles) {
    squares[observation.picture] += observation.residual.squaredNorm();
    corners[observation.picture] += static_cast<double>(observation.residual.cols());
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

/// Boards displaced in one picture only: of at most 48 views, those whose corners are farthest off together.
std::vector<TransientEvent> displacedBoards(const Measurements& measurements, const CalibrationResult& fit) {
  constexpr std::size_t most = 48;
  std::vector<std::pair<double, const BoardResidual*>> views; // with minus the size of their common error
  for (const BoardResidual& view : fit.withReportedAngles) {
    if (view.residual.cols() > 0) {
      views.emplace_back(-std::sqrt(static_cast<double>(view.residual.cols())) * view.residual.rowwise().mean().norm(),
                         &view);
    }
  }
  std::stable_sort(views.begin(), views.end(),
                   [](const auto& one, const auto& other) { return one.first < other.first; });
  views.resize(std::min(most, views.size()));
  std::vector<TransientEvent> result;
  for (const auto& [size, view] : views) {
    const ImageObservation& picture = measurements.pictures[view->picture];
    const std::string& board = measurements.targets[picture.observations[view->observation].view.board()].name;
    const int id = measurements.captureOf(picture).id;
    result.push_back({.term = makeBoardMove(measurements, view->picture, view->observation),
                      .who = fmt::format("board {} in capture {}", board, id),
                      .where = formatSet(picture.set, measurements),
                      .moved = board,
                      .set = picture.set,
                      .captures = {id}});
  }
  return result;
}

} // namespace

std::vector<std::optional<EventFit>> fitEvents(const std::vector<TransientEvent>& events, const FittedModel& fitted) {
  const double without = fitFrom(fitted.fit.unknowns, fitted).linear.cost;
  std::vector<std::optional<EventFit>> result(events.size());
  parallelFor(events.size(), [&](std::size_t i) {
    Model larger = fitted.model;
    larger.add(events[i].term);
    try {
      const FitMinimum minimum =
          fitFrom(mapParameters(fitted.model, fitted.fit.unknowns, larger), {fitted.measurements, larger, fitted.fit});
      const Term& term = larger.terms().back();
      result[i] = {2 * (without - minimum.linear.cost),
                   minimum.state.unknowns.segment(static_cast<Eigen::Index>(term.first), term.sigmas().size())};
    } catch (const InputError&) { // a corner behind the camera: no fit for this event
    }
  });
  return result;
}

bool isMoveAnyhow(const TransientEvent& event) {
  constexpr std::size_t degreesOfFreedom = 6;
  return event.from && event.term.effect.unknowns.size() == degreesOfFreedom;
}

bool isSameThing(const TransientEvent& one, const TransientEvent& other) {
  if (!one.from || !other.from) {
    return !one.from && !other.from && one.who == other.who && one.where == other.where;
  }
  return one.from->set == other.from->set && one.term.placeIndex == other.term.placeIndex &&
         one.term.effect.name == other.term.effect.name;
}

namespace {

/// Whether whole views still disagree with the rest: any of the event's captures, or more than a tenth of those after
/// its moment, as another accident may follow; or views that share something.
bool leavesOutliers(const TransientEvent& event, const Measurements& measurements, const CalibrationResult& fit) {
  constexpr double most = 0.1; // share
  const auto isConcerned = [&](const ImageObservation& picture) {
    const std::vector<int>& ids = event.captures;
    return picture.set == event.set &&
           (event.from ? isAfter(picture.instant, *event.from)
                       : std::find(ids.begin(), ids.end(), measurements.captureOf(picture).id) != ids.end());
  };
  double views = 0, outliers = 0;
  for (const ImageObservation& picture : measurements.pictures) {
    views += isConcerned(picture) ? static_cast<double>(picture.observations.size()) : 0;
  }
  for (const Outlier& outlier : fit.outliers) {
    outliers += outlier.whole && isConcerned(measurements.pictures[outlier.picture]) ? 1 : 0;
  }
  return outliers > (event.from ? most * views : 0) || !fit.sharedCauses.empty();
}

} // namespace

std::optional<EventEstimate> estimateEvent(const TransientEvent& event, const FittedModel& fitted,
                                           const Eigen::VectorXd& start) {
  constexpr double wide = 3; // an event has no usual size
  Term term = event.term;
  term.effect.inBaseModel = true; // no explanation does without it
  for (std::size_t i = 0; i < term.effect.unknowns.size(); ++i) {
    double& sigma = term.effect.unknowns[i].sigma;
    sigma = std::max(sigma, wide * std::abs(start[eigenIndex(i)]));
  }
  Model larger = fitted.model;
  larger.add(term);
  const std::size_t first = larger.terms().back().first;
  CalibrationOptions options;
  options.noise = fitted.fit.noise;
  options.excludeDisplaced = false;
  options.candidateTests.draws = 0;
  options.start = mapParameters(fitted.model, fitted.fit.unknowns, larger);
  options.start->tail(start.size()) = start;
  try {
    const CalibrationResult result = calibrate(fitted.measurements, larger, options);
    EventEstimate estimate{{},
                           result.noise,
                           leavesOutliers(event, fitted.measurements, result) ||
                               !(computeWald(result, larger.terms().back()) >= threshold::veryStrong)};
    for (std::size_t i = 0; i < term.effect.unknowns.size(); ++i) {
      const Estimate& one = result.estimates[first + i];
      const auto [low, high] = one.interval();
      estimate.values.push_back(
          {term.effect.unknowns[i].name, term.effect.unknowns[i].unit, one.best(), one.bestSigma(), low, high});
    }
    return estimate;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

namespace {

/// "+5.00 ± 0.02°"
std::string formatValue(const EventValue& value) {
  const auto [unit, factor] = displayUnit(value.unit);
  return appendUnit(
      fmt::format("{}{}", value.value < 0 ? "" : "+", formatEstimate(factor * value.value, factor * value.sigma)),
      unit);
}

/// " (x +29.0 ± 0.6 mm, ...)"; empty without sigmas.
std::string formatValues(const std::vector<EventValue>& values) {
  std::vector<std::string> parts;
  for (const EventValue& value : values) {
    if (value.sigma > 0) {
      parts.push_back(fmt::format("{} {}", value.unknown, formatValue(value)));
    }
  }
  return parts.empty() ? "" : fmt::format(" ({})", fmt::join(parts, ", "));
}

/// "LAnklePitch's zero changed by +0.40 ± 0.02° (95 %: +0.36° to +0.44°)"
std::string describeStep(const std::string& who, const EventValue& step) {
  const auto [unit, factor] = displayUnit(step.unit);
  if (step.sigma <= 0) {
    return fmt::format("{}'s zero changed by {}", who, appendUnit(fmt::format("{:+.2f}", factor * step.value), unit));
  }
  const int decimals = decimalsFor(factor * step.sigma);
  return fmt::format("{}'s zero changed by {} (95 %: {} to {})", who, formatValue(step),
                     appendUnit(fmt::format("{:+.{}f}", factor * step.low, decimals), unit),
                     appendUnit(fmt::format("{:+.{}f}", factor * step.high, decimals), unit));
}

Eigen::VectorXd numbersOf(const std::vector<EventValue>& values) {
  Eigen::VectorXd numbers(eigenIndex(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    numbers[eigenIndex(i)] = values[i].value;
  }
  return numbers;
}

std::string describeMove(const TransientEvent& event, const std::vector<EventValue>& values) {
  const PlaceKind place = event.term.effect.placeKind;
  const Eigen::VectorXd numbers = numbersOf(values);
  if (isMoveAnyhow(event)) {
    return fmt::format("{} moved by {:.3g} mm and {:.2g}°{}", event.who, millimetres * numbers.head<3>().norm(),
                       degrees(numbers.tail<3>().norm()), formatValues(values));
  }
  return place == PlaceKind::camera
             ? fmt::format("{} turned by {:.2f}°{}", event.who, degrees(numbers.norm()), formatValues(values))
             : fmt::format("{} moved by {:.0f} mm and {:.1f}°{}", event.who, millimetres * numbers.head<2>().norm(),
                           degrees(std::abs(numbers[2])), formatValues(values));
}

} // namespace

std::string describeEvent(const TransientEvent& event, const std::vector<EventValue>& values) {
  if (!event.from) {
    if (event.moved.empty()) {
      return fmt::format("{}{} {}", event.who, event.where, event.what);
    }
    Eigen::VectorXd sigmas(eigenIndex(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
      sigmas[eigenIndex(i)] = values[i].sigma;
    }
    return fmt::format("board {} lies {} in capture {}{} than in all others", event.moved,
                       describeBoardMove({numbersOf(values), sigmas}), event.captures.front(), event.where);
  }
  const std::string how = event.term.effect.placeKind == PlaceKind::motor ? describeStep(event.who, values.front())
                                                                          : describeMove(event, values);
  const auto& [set, time, since, until] = *event.from;
  return fmt::format("{}, {:.1f} s after the first capture{} (between {:.1f} and {:.1f} s)", how, time, event.where,
                     since, until);
}

std::vector<TransientEvent> enumerateEvents(const Measurements& measurements, const CalibrationResult& fit) {
  constexpr std::size_t most = 16; // per board, stance or camera
  constexpr std::size_t mostPictures = 128;
  std::vector<TransientEvent> result = movesAt(most, measurements);
  for (const std::size_t index : worstPictures(mostPictures, measurements, fit)) {
    const ImageObservation& picture = measurements.pictures[index];
    const int id = measurements.captureOf(picture).id;
    const std::string name = fmt::format("capture {}", id), where = formatSet(picture.set, measurements);
    result.push_back({.term = {makeBadPose({.set = picture.set, .time = picture.instant.time.count()}), picture.camera,
                               name + where},
                      .who = name,
                      .where = where,
                      .set = picture.set,
                      .captures = {id},
                      .what = "does not belong to the rest: another picture, or other angles"});
  }
  const std::vector<TransientEvent> displaced = displacedBoards(measurements, fit);
  result.insert(result.end(), displaced.begin(), displaced.end());
  return result;
}

std::vector<TransientEvent> spreadOverTime(const std::vector<TransientEvent>& things,
                                           const Measurements& measurements) {
  constexpr std::size_t most = 128;
  std::vector<TransientEvent> result = movesAt(most, measurements);
  std::erase_if(result, [&](const TransientEvent& event) {
    return std::none_of(things.begin(), things.end(),
                        [&](const TransientEvent& thing) { return isSameThing(event, thing); });
  });
  return result;
}

} // namespace naocal
