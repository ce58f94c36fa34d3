#include "diagnosis/anomalies/MovedFar.hpp"

#include "calibration/Fit.hpp"
#include "estimation/ModelBuilder.hpp"
#include "inference/Thresholds.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

namespace {

constexpr double manyCorners = 0.1; // share of all corners; more than a few misplaced pictures

/// Iterations after which a correction counts as wrong. A search with the right correction starts near its minimum and
/// needs 5 to 20; one with a wrong correction wanders for hundreds.
constexpr int mostIterations = 30;

/// rms distance of corners that a search in corrected sets leaves [px]. Absent if no fit is possible. `readings`: noise
/// levels of readings.
std::optional<double> fitCorrected(std::vector<CaptureSet> sets, const Measurements& asTheyAre,
                                   const std::vector<double>& readings) {
  try {
    const Measurements measurements = buildMeasurements(std::move(sets), asTheyAre.robot, asTheyAre.samePlace);
    const Model model = buildModel(measurements);
    CalibrationOptions options;
    options.maxIterations = mostIterations;
    // what joints scatter is nothing beside a move, and takes most of the time
    const Noise rigid{.encoder = 0, .readings = readings};
    const double rmsPx = rmsAsReported(measurements, model, fitInitially(measurements, model, rigid, options));
    return std::isfinite(rmsPx) ? std::optional{rmsPx} : std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// An object that may have been moved far between two captures.
struct MovedThing {
  std::string who, how;   // "board B", "was put elsewhere"
  std::set<double> times; // observation times within its set [s]
  std::size_t set = 0;
  std::function<void(CaptureSet&, double time)> separate; // splits it into two objects at this time
};

void startNewStance(CaptureSet& set, int stance, double time) {
  const auto highest = std::max_element(set.stances.begin(), set.stances.end(),
                                        [](const Stance& a, const Stance& b) { return a.id < b.id; });
  const auto found =
      std::find_if(set.stances.begin(), set.stances.end(), [&](const Stance& one) { return one.id == stance; });
  Stance anew = found == set.stances.end() ? Stance{.supportFoot = SupportFoot::left} : *found;
  anew.id = highest == set.stances.end() ? stance + 1 : std::max(highest->id, stance) + 1;
  anew.placement.reset();
  for (Capture& capture : set.captures) {
    if (capture.stance == stance && capture.time.count() > time) {
      capture.stance = anew.id;
    }
  }
  set.stances.push_back(anew);
}

void moveBoard(CaptureSet& set, const std::string& board, double time) {
  const std::string anew = board + " later";
  for (Capture& capture : set.captures) {
    if (!capture.corners || capture.time.count() <= time) {
      continue;
    }
    for (BoardCorners& seen : *capture.corners) {
      seen.board = seen.board == board ? anew : seen.board;
    }
  }
  Board other = *std::find_if(set.boards.begin(), set.boards.end(), [&](const Board& one) { return one.id == board; });
  other.id = anew;
  other.placement.reset();
  other.hasGuess = false;
  set.boards.push_back(std::move(other));
}

/// Stances shared by several captures, and boards on the floor if there are at least two.
std::vector<MovedThing> listMovedThings(const std::vector<CaptureSet>& sets) {
  std::vector<MovedThing> result;
  for (std::size_t number = 0; number < sets.size(); ++number) {
    std::map<int, std::set<double>> stances;
    std::map<std::string, std::set<double>> boards;
    for (const Capture& capture : sets[number].captures) {
      for (const BoardCorners& seen : capture.corners.value_or(std::vector<BoardCorners>{})) {
        stances[capture.stance].insert(capture.time.count());
        boards[seen.board].insert(capture.time.count());
      }
    }
    for (const auto& [stance, times] : stances) {
      result.push_back({fmt::format("the robot in stance {}", stance), "was put down anew", times, number,
                        [id = stance](CaptureSet& set, double time) { startNewStance(set, id, time); }});
    }
    for (const Board& board : sets[number].boards) {
      if (board.link == "floor" && boards.size() > 1 && boards.contains(board.id)) {
        result.push_back({"board " + board.id, "was put elsewhere", boards[board.id], number,
                          [id = board.id](CaptureSet& set, double time) { moveBoard(set, id, time); }});
      }
    }
  }
  std::erase_if(result, [](const MovedThing& thing) { return thing.times.size() < 2; });
  return result;
}

Seconds firstTime(const CaptureSet& set) {
  return std::min_element(set.captures.begin(), set.captures.end(),
                          [](const Capture& a, const Capture& b) { return a.time < b.time; })
      ->time;
}

/// Moment of a move with the smallest remaining misfit: coarse search over 16, then refined.
struct BestMoment {
  Moment moment;
  double left = std::numeric_limits<double>::infinity(); // rms distance of corners [px]
};
BestMoment findBestMoment(const MovedThing& thing, const Measurements& measurements,
                          const std::vector<double>& readings) {
  constexpr std::size_t coarse = 16;
  BestMoment best;
  const auto consider = [&](const std::vector<double>& moments) {
    for (const double time : moments) {
      std::vector<CaptureSet> corrected = *measurements.sets;
      thing.separate(corrected[thing.set], time);
      const auto left = fitCorrected(std::move(corrected), measurements, readings);
      if (left && *left < best.left) {
        const auto after = thing.times.upper_bound(time);
        best = {{thing.set, time, *std::prev(after), *after}, *left};
      }
    }
  };
  const std::vector<double> moments = midpointsOf(gapsBetween(thing.times), coarse);
  consider(moments);
  if (std::isfinite(best.left) && moments.size() == coarse) {
    const auto here = std::find(moments.begin(), moments.end(), best.moment.time);
    const double since = here == moments.begin() ? *thing.times.begin() : *std::prev(here);
    const double until = std::next(here) == moments.end() ? *thing.times.rbegin() : *std::next(here);
    const std::set<double> around{thing.times.lower_bound(since), thing.times.upper_bound(until)};
    consider(midpointsOf(gapsBetween(around), around.size()));
  }
  const double first = firstTime((*measurements.sets)[thing.set]).count();
  best.moment.time -= first;
  best.moment.since -= first;
  best.moment.until -= first;
  return best;
}

/// A move too large for the linearised events.
std::optional<DataAnomaly> findMovedFar(const Measurements& measurements, double least,
                                        const std::vector<double>& readings) {
  const std::vector<CaptureSet>& sets = *measurements.sets;
  constexpr double asGood = 1.05; // of the least misfit: the captures cannot tell which of them it was
  std::vector<std::pair<MovedThing, BestMoment>> mending;
  for (const MovedThing& thing : listMovedThings(sets)) {
    const BestMoment best = findBestMoment(thing, measurements, readings);
    if (best.left < least) {
      mending.emplace_back(thing, best);
    }
  }
  if (mending.empty()) {
    return std::nullopt;
  }
  std::stable_sort(mending.begin(), mending.end(),
                   [](const auto& a, const auto& b) { return a.second.left < b.second.left; });
  const auto& [thing, best] = mending.front();
  std::string others;
  for (std::size_t i = 1; i < mending.size() && mending[i].second.left < asGood * best.left; ++i) {
    others += fmt::format("{}{}", others.empty() ? ", unless it was " : " or ", mending[i].first.who);
  }
  const std::string of = sets.size() > 1 ? " of " + sets[thing.set].name : std::string{};
  return DataAnomaly{.why = fmt::format("{} {}, {:.1f} s after the first capture{} (between {:.1f} and {:.1f} s){} (so "
                                        "corrected the error is {:.1f} px)",
                                        thing.who, thing.how, best.moment.time, of, best.moment.since,
                                        best.moment.until, others, best.left),
                     .when = best.moment};
}

} // namespace

GrossMisfit GrossMisfit::assess(const CalibrationResult& fit) {
  double all = 0, far = 0;
  for (const BoardResidual& observation : fit.withReportedAngles) {
    all += static_cast<double>(observation.residual.cols());
    far += static_cast<double>((observation.residual.colwise().norm().array() > threshold::impossiblePx).count());
  }
  return {.rmsPx = fit.rmsPx, .farShare = far / std::max(1.0, all), .readings = fit.noise.readings};
}

std::optional<DataAnomaly> findMovedFar(const Measurements& measurements, const GrossMisfit& misfit) {
  if (measurements.cornerCount == 0 || misfit.rmsPx <= threshold::impossiblePx) {
    return std::nullopt;
  }
  const double least = std::min({threshold::correctionShare * std::min(misfit.rmsPx, threshold::impossiblePx),
                                 threshold::soundPx, misfit.explainedPx});
  if (auto moved = findMovedFar(measurements, least, misfit.readings)) {
    return moved;
  }
  if (misfit.rmsPx > threshold::absurdPx && misfit.farShare > manyCorners && std::isfinite(misfit.rmsPx)) {
    return DataAnomaly{{},
                       fmt::format("predictions are {:.0f} px off and no robot is so wrong: a board of another pattern "
                                   "(legacyPattern), other boards or another robot than the file says",
                                   misfit.rmsPx)};
  }
  return std::nullopt;
}

} // namespace naocal
