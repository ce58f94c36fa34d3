#include "diagnosis/anomalies/SetUps.hpp"

#include "calibration/Fit.hpp"
#include "effects/Catalogue.hpp"
#include "estimation/ModelBuilder.hpp"
#include "inference/DriverBasis.hpp"
#include "inference/Thresholds.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

namespace {

constexpr double mostOffset = radians(15); // no robot with a larger offset can stand
constexpr double some = 0.1;               // share of all corners; more than a few misplaced pictures

/// Iterations after which a correction counts as wrong. A search with the right correction starts near its minimum and
/// needs 5 to 20; one with a wrong correction wanders for hundreds.
constexpr int mostIterations = 30;

/// The offset furthest from zero.
struct LargestOffset {
  std::string joint;
  double value = 0; // [rad]
};
LargestOffset findLargestOffset(const Model& model, const Eigen::VectorXd& unknowns) {
  LargestOffset result;
  for (const Term& term : model.terms()) {
    const double value =
        term.effect.name == effectName::jointOffset ? unknowns[static_cast<Eigen::Index>(term.first)] : 0;
    if (std::abs(value) > std::abs(result.value)) {
      result = {term.placeName, value};
    }
  }
  return result;
}

/// What a search that starts with corrected sets leaves.
struct Correction {
  double rmsPx = 0;  // of corners, or of readings as far off
  double offset = 0; // largest offset of a joint [rad]
};

/// Absent if no fit is possible. `readings`: noise levels of readings.
std::optional<Correction> fitCorrected(std::vector<CaptureSet> sets, const Measurements& asTheyAre,
                                       const std::vector<double>& readings) {
  try {
    const Measurements measurements = buildMeasurements(std::move(sets), asTheyAre.robot, asTheyAre.samePlace);
    const Model model = buildModel(measurements);
    CalibrationOptions options;
    options.maxIterations = mostIterations;
    // what joints scatter is nothing beside a set-up error, and takes most of the time
    const Noise rigid{.encoder = 0, .readings = readings};
    const Fit fit = fitInitially(measurements, model, rigid, options);
    const double rmsPx = rmsAsReported(measurements, model, fit);
    if (!std::isfinite(rmsPx)) {
      return std::nullopt;
    }
    return Correction{rmsPx, std::abs(findLargestOffset(model, fit.minimum.state.unknowns).value)};
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Turns a joint's angles and its direction of motion around.
std::vector<CaptureSet> mirrorJoint(std::vector<CaptureSet> sets, const std::string& joint) {
  for (CaptureSet& set : sets) {
    const auto place = static_cast<std::size_t>(std::find(set.jointNames.begin(), set.jointNames.end(), joint) -
                                                set.jointNames.begin());
    for (Capture& capture : set.captures) {
      JointReadings& readings = capture.joints;
      for (std::vector<double>* values :
           {&readings.measured, &readings.commanded, &readings.velocity, &readings.approach}) {
        if (place < values->size()) { // what was not recorded is empty
          (*values)[place] = -(*values)[place];
        }
      }
    }
  }
  return sets;
}

/// Swaps what two joints read.
std::vector<CaptureSet> swapJoints(std::vector<CaptureSet> sets, const std::string& one, const std::string& other) {
  for (CaptureSet& set : sets) {
    const auto first = std::find(set.jointNames.begin(), set.jointNames.end(), one),
               second = std::find(set.jointNames.begin(), set.jointNames.end(), other);
    if (first != set.jointNames.end() && second != set.jointNames.end()) {
      std::iter_swap(first, second);
    }
  }
  return sets;
}

std::vector<CaptureSet> swapCameras(std::vector<CaptureSet> sets) {
  for (CaptureSet& set : sets) {
    for (Capture& capture : set.captures) {
      capture.camera = capture.camera == "top" ? "bottom" : "top";
    }
  }
  return sets;
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
      if (left && left->rmsPx < best.left) {
        const auto after = thing.times.upper_bound(time);
        best = {{thing.set, time, *std::prev(after), *after}, left->rmsPx};
      }
    }
  };
  const std::vector<double> moments = midpointsBetween(thing.times, coarse);
  consider(moments);
  if (std::isfinite(best.left) && moments.size() == coarse) {
    const auto here = std::find(moments.begin(), moments.end(), best.moment.time);
    const double since = here == moments.begin() ? *thing.times.begin() : *std::prev(here);
    const double until = std::next(here) == moments.end() ? *thing.times.rbegin() : *std::next(here);
    const std::set<double> around{thing.times.lower_bound(since), thing.times.upper_bound(until)};
    consider(midpointsBetween(around, around.size()));
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

namespace {

/// Adds an angle to all readings of a joint [rad].
void shiftJoint(std::vector<CaptureSet>& sets, const std::string& joint, double shift) {
  for (CaptureSet& set : sets) {
    const auto found = std::find(set.jointNames.begin(), set.jointNames.end(), joint);
    for (Capture& capture : set.captures) {
      if (found != set.jointNames.end()) {
        capture.joints.measured[static_cast<std::size_t>(found - set.jointNames.begin())] += shift;
      }
    }
  }
}

/// One motor turn of a joint, seen at the joint [rad]; 0 if the set does not say.
double slipStepOf(const std::vector<CaptureSet>& sets, const std::string& joint) {
  const auto step = sets.front().slipSteps.find(joint);
  return step == sets.front().slipSteps.end() ? 0 : step->second;
}

/// Motor turns that a joint's zero is off, according to a first fit.
long slippedTurns(const std::vector<CaptureSet>& sets, const Robot& robot, const std::string& joint) {
  const Measurements measurements = buildMeasurements(sets, robot);
  const Model model = buildModel(measurements);
  const Term* const offset = model.find(std::string{effectName::jointOffset} + '@' + joint);
  if (!offset) {
    return 0;
  }
  const Fit fit = fitInitially(measurements, model, Noise{.encoder = 0}, {});
  return std::lround(fit.minimum.state.unknowns[static_cast<Eigen::Index>(offset->first)] / slipStepOf(sets, joint));
}

} // namespace

bool isSetUp(const std::string& label) {
  return label.starts_with(reversedJoint) || label.starts_with(countSlip);
}

std::vector<std::string> mendSetUps(std::vector<std::string>& with, const Robot& robot, std::vector<CaptureSet>& sets) {
  std::vector<std::string> rest, mended;
  for (const std::string& label : with) {
    const std::string joint = label.substr(std::min(label.find('@'), label.size() - 1) + 1);
    if (!isSetUp(label)) {
      rest.push_back(label);
      continue;
    }
    const auto& names = sets.front().jointNames;
    if (std::find(names.begin(), names.end(), joint) == names.end()) {
      throw InputError{fmt::format("'{}' names no joint of these captures; near it are {}", label,
                                   fmt::join(closestNames(joint, names), ", "))};
    }
    if (label.starts_with(reversedJoint)) {
      sets = mirrorJoint(std::move(sets), joint);
    } else if (const double step = slipStepOf(sets, joint); step > 0) {
      shiftJoint(sets, joint, -step * static_cast<double>(slippedTurns(sets, robot, joint)));
    } else {
      throw InputError{fmt::format("'{}' needs the motor's turn at the joint: expected slipSteps.{} in the captures, "
                                   "found none",
                                   label, joint)};
    }
    mended.push_back(label);
  }
  with = std::move(rest);
  return mended;
}

std::vector<DataAnomaly> findSlippedCounts(const FittedModel& fitted) {
  std::vector<DataAnomaly> result;
  for (const Term& term : fitted.model.terms()) {
    const double step = slipStepOf(*fitted.measurements.sets, term.placeName);
    if (term.effect.name != effectName::jointOffset || !(step > 0)) {
      continue;
    }
    const Estimate& offset = fitted.fit.estimates[term.first];
    const long turns = std::lround(offset.value / step);
    if (turns != 0 && offset.learned > threshold::learned) {
      result.push_back(
          {.why = fmt::format("{}'s zero is off by {:.1f}°, about {} turn{} of its motor ({:.1f}° each): the "
                              "count slipped",
                              term.placeName, degrees(offset.value), turns, turns == 1 ? "" : "s", degrees(step)),
           .setUp = countSlip + term.placeName});
    }
  }
  return result;
}

GrossMisfit GrossMisfit::assess(const Measurements& measurements, const CalibrationResult& fit, const Model& model) {
  double all = 0, far = 0;
  for (const BoardResidual& observation : fit.withReportedAngles) {
    all += static_cast<double>(observation.residual.cols());
    far += static_cast<double>((observation.residual.colwise().norm().array() > threshold::impossiblePx).count());
  }
  const auto isLoose = [&](std::size_t level) {
    const ReadingLevel& known = measurements.levels[level];
    const double most = known.unit == ReadingLevel::Unit::metres ? threshold::grossMetres : threshold::grossRadians;
    return !known.isGiven && fit.noise.readings[level] > most;
  };
  bool loose = false;
  for (std::size_t level = 0; level < fit.noise.readings.size(); ++level) {
    loose |= isLoose(level);
  }
  const LargestOffset largest = findLargestOffset(model, fit.unknowns);
  const bool isFar = std::abs(largest.value) > mostOffset;
  return {.rmsPx = fit.rmsPx,
          .farShare = far / std::max(1.0, all),
          .farJoint = isFar ? largest.joint : "",
          .farOffset = isFar ? largest.value : 0,
          .isLoose = loose,
          .readings = fit.noise.readings};
}

bool GrossMisfit::isGross() const {
  return isLoose || rmsPx >= threshold::grossPx;
}

bool GrossMisfit::isAbsurd() const {
  return !farJoint.empty() || isLoose || rmsPx > threshold::impossiblePx;
}

namespace {

DataAnomaly reversed(const std::string& joint) {
  return {.why = fmt::format("{}'s angles have the wrong sign", joint), .setUp = reversedJoint + joint};
}

/// The joint whose mirrored angles fit as well with the smallest offsets, none of them far.
std::optional<DataAnomaly> findImitatedMirror(const Measurements& measurements, const GrossMisfit& misfit) {
  constexpr double asGood = 1.1; // of the misfit: a coarse search ends a little above its minimum
  std::optional<DataAnomaly> best;
  double least = mostOffset;
  for (const std::size_t joint : measurements.joints) {
    const std::string& name = measurements.robot.joints[joint].name;
    const auto left = fitCorrected(mirrorJoint(*measurements.sets, name), measurements, misfit.readings);
    if (left && left->rmsPx < asGood * misfit.rmsPx && left->offset < least) {
      least = left->offset;
      best = reversed(name);
      best->why += fmt::format(", or {}'s zero is off by {:.0f}°: these captures cannot tell", misfit.farJoint,
                               degrees(misfit.farOffset));
    }
  }
  return best;
}

} // namespace

std::optional<DataAnomaly> findSetupError(const Measurements& measurements, const GrossMisfit& misfit,
                                          const std::function<bool(std::size_t)>& mayBeMirrored) {
  if (!misfit.isGross()) {
    return misfit.farJoint.empty() ? std::nullopt : findImitatedMirror(measurements, misfit);
  }
  const std::vector<CaptureSet>& sets = *measurements.sets;
  std::optional<DataAnomaly> best;
  double least = std::min({threshold::correctionShare * std::min(misfit.rmsPx, threshold::impossiblePx),
                           threshold::soundPx, misfit.explainedPx});
  const auto consider = [&](std::vector<CaptureSet> corrected, DataAnomaly anomaly) {
    const auto left = fitCorrected(std::move(corrected), measurements, misfit.readings);
    if (left && left->rmsPx < least) {
      least = left->rmsPx;
      if (measurements.cornerCount > 0) {
        anomaly.why += fmt::format(" (so corrected the error is {:.1f} px)", least);
      }
      best = std::move(anomaly);
    }
  };
  for (std::size_t joint : measurements.joints) {
    const std::string& name = measurements.robot.joints[joint].name;
    if (misfit.isAbsurd() || mayBeMirrored(joint)) {
      consider(mirrorJoint(sets, name), reversed(name));
    }
  }
  for (std::size_t i = 0; i < measurements.joints.size() && !sets.front().urdf.empty(); ++i) {
    for (std::size_t j = i + 1; j < measurements.joints.size(); ++j) {
      const std::string &one = measurements.robot.joints[measurements.joints[i]].name,
                        &other = measurements.robot.joints[measurements.joints[j]].name;
      consider(swapJoints(sets, one, other), {.why = fmt::format("the angles of {} and {} are swapped", one, other)});
    }
  }
  if (sets.front().cameras.size() == 2 && sets.front().urdf.empty()) {
    consider(swapCameras(sets), {.why = "the cameras' names are swapped"});
  }
  if (!best && misfit.rmsPx > threshold::impossiblePx) {
    best = findMovedFar(measurements, least, misfit.readings);
  }
  if (!best && misfit.rmsPx > threshold::absurdPx && misfit.farShare > some && std::isfinite(misfit.rmsPx)) {
    best = DataAnomaly{{},
                       fmt::format("predictions are {:.0f} px off and no robot is so wrong: a board of another pattern "
                                   "(legacyPattern), other boards or another robot than the file says",
                                   misfit.rmsPx)};
  }
  return best;
}

} // namespace naocal
