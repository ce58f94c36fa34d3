#include "brain/CalibrationRunner.hpp"
#include "brain/LegPoses.hpp"
#include "brain/SavedCalibration.hpp"
#include "captures/Files.hpp"
#include "geometry/Angles.hpp"

#include <algorithm>
#include <deque>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

/// The rounds of a calibration: what is done by the worker, and what follows from what it finds.
namespace naocal {
namespace {

using Phase = CalibrationState::Phase;

constexpr double leastGain = 0.5; // what a calibration leaves of the error at most, to be kept
constexpr double goodError = 1.5; // [px]; 2 cm on the floor, two metres away

/// Each foot's poses, one foot after the other; each time that the robot steps onto one is a stance.
CalibrationRound legRound(const std::deque<LegPoses>& legs, RoundOptions options) {
  CalibrationRound round;
  int stance = 0;
  for (const LegPoses& leg : legs) {
    const CalibrationRound onFoot = leg.round(options, stance++);
    round.insert(round.end(), onFoot.begin(), onFoot.end());
  }
  return round;
}

} // namespace

void CalibrationRunner::prepare() {
  enter(Phase::preparing, "The ways between the poses are being checked.");
  give([files = surroundings_.files, folder = folder_](Finding&) {
    std::filesystem::create_directories(folder);
    std::filesystem::copy(files, folder / "configuration", std::filesystem::copy_options::recursive);
  });
  RoundOptions options{*repeats_, radians(*approach_), 0, *orderSeed_};
  if (kind_->feet.front() == SupportFoot::both) {
    rounds_[0] = headRound(player_.home, *yaws_, *pitches_, options.pictures);
    rounds_[1] = rounds_[0];
    for (CalibrationStep& step : rounds_[1]) { // to check, other places than those that were calibrated with
      for (CompensatedAngles& pose : step.points) {
        pose = interpolated(pose, player_.home, 0.3);
      }
    }
    return startRound();
  }
  give([options, checkPoses = *checkPoses_, kind = kind_, home = player_.home, &drawing = surroundings_.drawing,
        file = kind_ == &askedKind_ ? folder_ / "poses.json"
                                    : surroundings_.files / "poses" / (surroundings_.drawing.model + ".json"),
        asked = kind_ == &askedKind_ ? askedPoses_->content : ""](Finding& finding) mutable {
    if (!asked.empty()) { // what was asked for stays with what was recorded
      std::filesystem::create_directories(file.parent_path());
      writeAtomically(file, asked);
    }
    const PoseFile poses = readPoseFile(file, drawing);
    std::deque<LegPoses> legs;
    for (const SupportFoot foot : kind->feet) {
      legs.emplace_back(drawing, poses, foot, home);
    }
    finding.rounds.emplace();
    finding.rounds->at(0) = legRound(legs, options);
    ++options.seed;
    options.poses = static_cast<std::size_t>(checkPoses);
    finding.rounds->at(1) = legRound(legs, options);
  });
}

void CalibrationRunner::startRound() {
  const CalibrationRound& round = rounds_[round_];
  step_ = 0;
  state_.edit().pose = 0;
  state_.edit().poses = static_cast<int>(
      std::count_if(round.begin(), round.end(), [](const CalibrationStep& step) { return step.pictures > 0; }));
  roundStart_.reset();
  sessions_[round_] = std::make_shared<Round>();
  give([session = sessions_[round_], &drawing = surroundings_.drawing, header = header(),
        folder = folder_ / (round_ == 0 ? "first" : "second")](Finding&) {
    session->session.emplace(drawing, header, folder);
  });
  nextStep();
}

void CalibrationRunner::take(const Capture& capture) {
  ShownCapture shown{++state_.edit().captures, static_cast<int>(round_), capture.pose, capture.camera, {}, {}};
  shownCaptures_.edit().push_back(shown);
  give([this, round = sessions_[round_], folder = folder_, capture, shown, frame = picture_->frame](Finding&) mutable {
    if (lookedAt_.folder != folder) {
      lookedAt_ = {folder, {}};
    }
    shown.corners = 0;
    for (const BoardCorners& board : round->session.value().add(capture, frame)) {
      shown.boards.push_back(board.board);
      *shown.corners += static_cast<int>(board.ids.size());
    }
    lookedAt_.captures.push_back(std::move(shown));
    looked_.write(lookedAt_);
  });
}

void CalibrationRunner::takeLooked() {
  const Looked* looked = looked_.take();
  if (looked != nullptr && looked->folder == folder_) {
    std::copy(looked->captures.begin(), looked->captures.end(), shownCaptures_.edit().begin());
  }
}

void CalibrationRunner::endRound() {
  ask(PoseRequest::Kind::home, "The stand", {}); // it is there, and can be let go
  if (kind_ == &askedKind_) {
    return enter(Phase::finished, fmt::format("All poses were taken; what was seen lies in {} on the robot.",
                                              (folder_ / "first").string()));
  }
  round_ == 0 ? solve() : check();
}

void CalibrationRunner::give(std::function<void(Finding&)> task) {
  worker_.add([this, folder = folder_, task = std::move(task)] {
    Finding finding{.folder = folder};
    try {
      task(finding);
    } catch (const std::exception& error) {
      finding.problem = error.what();
    }
    if (finding.rounds || finding.isApplied || finding.error || !finding.problem.empty()) {
      findings_.write(std::move(finding));
    }
  });
}

void CalibrationRunner::solve() {
  enter(Phase::solving, "The captures are being solved.");
  give([this, round = sessions_[0], before = before_,
        onlyHead = kind_->feet.front() == SupportFoot::both](Finding& finding) {
    const CalibrationSession::Solved solved = round->session.value().solved();
    const std::vector<ShownOffset> offsets = onlyHead ? ofHead(solved.offsets) : solved.offsets;
    finding.outcome = shownOutcome(before, offsets, lookedAt_.captures);
    for (const Warning& warning : solved.warnings) { // only with the legs it is known where the floor is
      if (warning.about == Warning::About::fit || (warning.about == Warning::About::floor && !onlyHead)) {
        finding.outcome->warnings.push_back(warning.sentence);
      }
    }
    apply(learned(offsets), solved.result, surroundings_.configuration);
    finding.isApplied = true;
  });
}

void CalibrationRunner::check() {
  enter(Phase::checking, "The second round is being compared with what was solved.");
  give([second = sessions_[1], before = before_, &configuration = surroundings_.configuration](Finding& finding) {
    finding.error = second->session.value().error(before, configured(configuration));
    if (finding.error->after > leastGain * finding.error->before) {
      takeBack(configuration);
    }
  });
}

void CalibrationRunner::takeFinding() {
  Finding* finding = findings_.take();
  if (finding == nullptr || finding->folder != folder_ || !state_->runs()) {
    return;
  }
  if (!finding->problem.empty()) {
    fail(fmt::format("The calibration ended: {}", finding->problem));
  } else if (finding->rounds) {
    rounds_ = std::move(*finding->rounds);
    startRound();
  } else if (finding->isApplied) {
    shownOutcome_ = *finding->outcome;
    round_ = 1;
    startRound();
  } else if (finding->error) {
    tellError(*finding->error);
  }
}

void CalibrationRunner::tellError(const CalibrationSession::Error& error) {
  state_.edit().errorBefore = error.before;
  state_.edit().errorAfter = error.after;
  const std::string errors =
      fmt::format("from {:.1f} to {:.1f} pixels in corners that were not calibrated with", error.before, error.after);
  if (error.after <= leastGain * error.before) {
    enter(Phase::finished,
          fmt::format("The measured error fell {}. The calibration is saved; it can be undone.", errors));
  } else if (error.before <= goodError) {
    enter(Phase::finished,
          fmt::format("The robot was well calibrated already (the measured error went {}), so it keeps "
                      "what it had.",
                      errors));
  } else {
    enter(Phase::failed,
          fmt::format("The measured error went {}: it did not fall by half, so the calibration was taken "
                      "back. Something else is off as well: calibrate the legs, or look at the "
                      "recording with 'naocal diagnose'.",
                      errors));
  }
}

CaptureSet CalibrationRunner::header() const {
  CaptureSet set;
  set.model = surroundings_.drawing.model;
  set.headId = surroundings_.identity.headId;
  set.bodyId = surroundings_.identity.bodyId;
  set.jointNames = {jointNames.begin(), jointNames.end()};
  for (const auto& [name, belief] : *cameras_) {
    set.cameras[name] = belief.intrinsics;
  }
  set.boards = boards_->boards;
  for (std::size_t foot = 0; foot < kind_->feet.size(); ++foot) {
    set.stances.push_back({static_cast<int>(foot), kind_->feet[foot], std::nullopt});
  }
  return set;
}

} // namespace naocal
