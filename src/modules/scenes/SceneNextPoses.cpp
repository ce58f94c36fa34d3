#include "scenes/SceneNextPoses.hpp"

#include "calibration/result/PlacementFile.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/InputError.hpp"
#include "math/Checkpoints.hpp"
#include "math/LinearAlgebra.hpp"
#include "poses/criteria/Discrimination.hpp"
#include "poses/criteria/PlannedInformation.hpp"
#include "robot/LegKinematics.hpp"
#include "robot/RobotOfSet.hpp"
#include "scenes/SceneCandidates.hpp"
#include "scenes/TrueRobot.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

/// A set's entries at the places of a fit.
class FittedPlaces {
public:
  explicit FittedPlaces(const FittedModel& fitted)
      : stored_{parsePlacements(placementsJson(fitted))}, measurements_{fitted.measurements} {}

  /// The last set without captures, everything placed; without what was never measured.
  CaptureSet placeLastSet() const {
    CaptureSet set = measurements_.sets->back();
    const Stance last = lastStance();
    set.captures.clear();
    set.stances = {last};
    set.stances.front().placement = standing();
    keepPlaced(set.boards, stored_.boards, &Board::placement);
    keepPlaced(set.instruments.trackers, stored_.trackers, &Tracker::placement);
    keepPlaced(set.instruments.frames, stored_.frames, &TrackedFrame::placement);
    keepPlaced(set.instruments.markers, stored_.markers, &TrackedMarker::point);
    set.instruments.places.clear();
    set.instruments.distances.clear();
    for (auto& [name, mounting] : set.mountings) {
      if (const auto found = stored_.cameras.find(name); found != stored_.cameras.end()) {
        mounting.placement = found->second;
      }
    }
    std::erase_if(set.cameras, [&](const auto& camera) {
      const auto mounting = set.mountings.find(camera.first);
      return mounting != set.mountings.end() && mounting->second.link == "world" && !mounting->second.placement;
    });
    return set;
  }

  Stance lastStance() const {
    const CaptureSet& set = measurements_.sets->back();
    return *std::find_if(set.stances.begin(), set.stances.end(),
                         [&](const Stance& stance) { return stance.id == set.captures.back().stance; });
  }

  /// Unknowns of a larger model: those of the fit, and placements where they were. A new stance is where the last was.
  Eigen::VectorXd extend(const FittedModel& fitted, const Measurements& extended, const Model& model,
                         int newStance) const {
    StoredPlacements stored = stored_;
    if (const auto place = standing()) {
      stored.stances.try_emplace(nameOf(std::to_string(newStance)), *place);
    }
    Eigen::VectorXd unknowns = mapParameters(fitted.model, fitted.fit.unknowns, model);
    for (const Term& term : model.terms()) {
      if (term.isPlacement) {
        placeAsStored(stored, extended, term, unknowns);
      }
    }
    return unknowns;
  }

private:
  std::string nameOf(const std::string& id) const {
    const bool oneScope = measurements_.sets->size() == 1 || measurements_.samePlace;
    return oneScope ? id : measurements_.sets->back().name + "/" + id;
  }

  std::optional<Placement> standing() const {
    const auto found = stored_.stances.find(nameOf(std::to_string(lastStance().id)));
    return found == stored_.stances.end() ? lastStance().placement : std::optional{found->second};
  }

  /// Places entries as stored, and removes those without a place.
  template <typename Entry, typename Place>
  void keepPlaced(std::vector<Entry>& entries, const std::map<std::string, Place>& stored,
                  std::optional<Place> Entry::*place) const {
    for (Entry& entry : entries) {
      if (const auto found = stored.find(nameOf(entry.id)); found != stored.end()) {
        entry.*place = found->second;
      }
    }
    std::erase_if(entries, [&](const Entry& entry) { return !(entry.*place); });
  }

  StoredPlacements stored_;
  const Measurements& measurements_;
};

/// The span of each joint's angles in a set, widened.
std::map<std::string, AngleRange> widenedRanges(const CaptureSet& set, const Robot& robot) {
  constexpr double share = 0.5, turn = 0.3, slide = 0.03; // [1], [rad], [m]
  std::map<std::string, AngleRange> ranges;
  for (std::size_t i = 0; i < set.jointNames.size(); ++i) {
    const auto joint = robot.jointIndex(set.jointNames[i]);
    AngleRange span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Capture& capture : set.captures) {
      if (i < capture.joints.measured.size() && std::isfinite(capture.joints.measured[i])) {
        span.lower = std::min(span.lower, capture.joints.measured[i]);
        span.upper = std::max(span.upper, capture.joints.measured[i]);
      }
    }
    if (joint && span.lower <= span.upper) {
      const double wider = std::max(share * (span.upper - span.lower), robot.joints[*joint].isPrismatic ? slide : turn);
      ranges[set.jointNames[i]] = {span.lower - wider, span.upper + wider};
    }
  }
  return ranges;
}

/// Candidates of a fitted robot, and the sets with their captures.
struct NextCandidates {
  std::vector<CaptureSet> sets;
  std::vector<ProposedPose> poses;
  PassCounts sieve;
};

/// Whether the encoders of a robot can read these angles.
bool isWithinJoints(const Robot& robot, const Eigen::VectorXd& recorded) {
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const AngleRange limits = jointLimitsAt(robot, joint, recorded);
    const double angle = recorded[eigenIndex(joint)];
    if (robot.joints[joint].motor == joint && (angle < limits.lower || angle > limits.upper)) {
      return false;
    }
  }
  return true;
}

NextCandidates drawNext(const std::vector<CaptureSet>& sets, TrueRobot& robot, int stance,
                        const NextPosesOptions& options) {
  constexpr std::size_t drawsPerCandidate = 250;
  NextCandidates result{sets, {}, {}};
  std::mt19937_64 random{options.seed};
  robot.poses().takeCounts();
  CaptureSet& set = result.sets.back();
  for (std::size_t draw = 0; draw < drawsPerCandidate * options.candidates && result.poses.size() < options.candidates;
       ++draw) {
    Checkpoints::reach();
    const auto angles = robot.poses().draw();
    const Eigen::VectorXd recorded = angles ? robot.recordedAt(*angles) : Eigen::VectorXd{};
    if (!angles || !isWithinJoints(robot.robot(), recorded)) {
      continue;
    }
    const Eigen::VectorXd approach = drawApproach(robot.robot(), random);
    Capture planned = plannedCapture(sets.back(), robot.robot(), recorded, approach);
    const TrueRobot::Sight sight =
        robot.look({recorded, approach, planned.time, Eigen::VectorXd::Zero(recorded.size())});
    if (!sight.isEnough) {
      continue;
    }
    planned.pose = plannedPoseName(result.poses.size());
    planned.stance = stance;
    for (const Capture& seen : sight.captures) {
      if (showsAnything(seen)) {
        Capture& capture = set.captures.emplace_back(planned);
        capture.camera = seen.camera;
        capture.corners = seen.corners;
        capture.points = seen.points;
        capture.frames = seen.frames;
      }
    }
    result.poses.push_back({describeSight(robot.set(), sight.captures, recorded), approach});
  }
  result.sieve = robot.poses().takeCounts();
  return result;
}

} // namespace

NextPoses proposeSceneNextPoses(const FittedModel& fitted, const ModelAmbiguity& question,
                                const NextPosesOptions& options) {
  const Measurements& measurements = fitted.measurements;
  if (hasPlannableLegs(measurements.robot)) {
    return proposeNextPoses(fitted, question, options);
  }
  const std::vector<CaptureSet>& sets = *measurements.sets;
  NextPoses result;
  result.why = question.why;
  if (question.suspects.empty()) {
    result.whyNone = question.whyNone;
    return result;
  }
  if (options.count == 0) {
    return result;
  }
  const FittedPlaces places{fitted};
  const RobotScene scene{
      .set = places.placeLastSet(), .about = {}, .ranges = widenedRanges(sets.back(), measurements.robot), .noise = {}};
  if (scene.set.cameras.empty() && scene.set.instruments.trackers.empty()) {
    result.whyNone = "neither a camera nor a tracker measured the robot in the last set, and touches are not planned";
    return result;
  }
  const ScenePlan still{.given = {}, .seed = options.seed, .robotSeed = {}, .sceneSeed = {}, .spread = 0};
  TrueRobot robot{scene, still};
  robot.adoptFit(fitted.model, fitted.fit.unknowns, question.effects);
  const Stance last = places.lastStance();
  const int stance = robot.isOnSole() ? plannedStanceId(sets, SupportFoot::left) : last.id;
  NextCandidates candidates = drawNext(sets, robot, stance, options);
  if (candidates.poses.empty()) {
    result.whyNone = "no pose was found in which enough is measured";
    return result;
  }
  if (robot.isOnSole()) {
    Stance anew = last;
    anew.id = stance;
    anew.placement.reset();
    candidates.sets.back().stances.push_back(anew);
  }
  const Measurements extended =
      buildMeasurements(std::move(candidates.sets), measurements.robot, measurements.samePlace);
  Model own = buildModel(extended, question.with, question.without, question.effects);
  const Model model = addHypotheses(extended, own, question);
  result.samples = samplesPerPose(measurements);
  PlannedInformation information =
      linearizePlans(extended, model, fitted.fit.noise, places.extend(fitted, extended, model, stance),
                     candidates.poses.size(), result.samples);
  information.own = std::move(own);
  result.stable = candidates.sieve.stable;
  result.seeing = candidates.poses.size();
  result.noise = fitted.fit.noise;
  result.firstStance = stance;
  const auto always = [](const ProposedPose&) { return true; };
  selectNextPoses(question, information, candidates.poses, always, options, result);
  return result;
}

NextPoses proposeSceneNextPoses(const Measurements& measurements, const Diagnosis& diagnosis,
                                const DiagnosisOptions& asked, const NextPosesOptions& options) {
  try {
    const Model model = buildModel(measurements, diagnosis.with, asked.without, asked.calibration.effects);
    CalibrationResult fit = diagnosis.lastFit;
    fit.noise.pose = diagnosis.scatter;
    return proposeSceneNextPoses({measurements, model, fit}, findAmbiguity(diagnosis, measurements.robot, asked),
                                 options);
  } catch (const InputError& error) {
    NextPoses none;
    none.whyNone = error.what();
    return none;
  }
}

} // namespace naocal
