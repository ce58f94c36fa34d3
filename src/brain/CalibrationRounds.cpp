#include "brain/CalibrationRunner.hpp"
#include "brain/HeadCalibration.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

/// The rounds of a calibration: what is done by the worker, and what follows from what it finds.
namespace naocal {
namespace {

using Phase = CalibrationState::Phase;

constexpr double leastGain = 0.5; // what a calibration leaves of the error at most, to be kept

} // namespace

void CalibrationRunner::goOn() {
  if (!first_) {
    startRound(first_, "first");
  } else if (!second_) {
    solve();
  } else {
    check();
  }
}

void CalibrationRunner::startRound(std::shared_ptr<Round>& round, const std::string& name) {
  round = std::make_shared<Round>();
  poses_ = headPoses(player_.home, *yaws_, *pitches_);
  if (name == "second") { // to check, other places than those that were calibrated with
    for (CompensatedAngles& pose : poses_) {
      pose = interpolated(pose, player_.home, 0.3);
    }
  }
  state_.edit().pose = 0;
  state_.edit().poses = static_cast<int>(poses_.size());
  roundStart_.reset();
  give([round, &drawing = surroundings_.drawing, header = header(), folder = folder_ / name](Finding&) {
    round->session.emplace(drawing, header, folder);
  });
  nextPose();
}

void CalibrationRunner::give(std::function<void(Finding&)> task) {
  worker_.add([this, folder = folder_, task = std::move(task)] {
    Finding finding{.folder = folder};
    try {
      task(finding);
    } catch (const std::exception& error) {
      finding.problem = error.what();
    }
    if (finding.isApplied || finding.error || !finding.problem.empty()) {
      findings_.write(std::move(finding));
    }
  });
}

void CalibrationRunner::solve() {
  enter(Phase::solving, "The captures are being solved.");
  give([round = first_, &configuration = surroundings_.configuration](Finding& finding) {
    apply(ofHead(round->session.value().solved()), configuration);
    finding.isApplied = true;
  });
}

void CalibrationRunner::check() {
  enter(Phase::checking, "The second round is being compared with what was solved.");
  give([second = second_, file = folder_ / "first" / "result.json",
        &configuration = surroundings_.configuration](Finding& finding) {
    finding.error = second->session.value().error(ofHead(readResult(file)));
    if (finding.error->after > leastGain * finding.error->before) {
      takeBack(configuration);
    }
  });
}

void CalibrationRunner::takeFinding() {
  const Finding* finding = findings_.take();
  const Phase phase = state_->phase;
  if (finding == nullptr || finding->folder != folder_ || phase == Phase::idle || phase == Phase::finished ||
      phase == Phase::failed) {
    return;
  }
  if (!finding->problem.empty()) {
    ask(PoseRequest::Kind::home, "", {});
    enter(Phase::failed, fmt::format("The calibration ended: {}", finding->problem));
  } else if (finding->isApplied) {
    startRound(second_, "second");
  } else if (finding->error) {
    tellError(*finding->error);
  }
}

void CalibrationRunner::tellError(const CalibrationSession::Error& error) {
  state_.edit().errorBefore = error.before;
  state_.edit().errorAfter = error.after;
  const std::string fell = fmt::format("The error of corners that were not calibrated with fell from {:.1f} to {:.1f} "
                                       "pixels",
                                       error.before, error.after);
  if (error.after > leastGain * error.before) {
    enter(Phase::failed, fell +
                             ", not even by half, so the calibration was taken back. Neck and cameras are not all that "
                             "is off: calibrate the legs first.");
  } else {
    enter(Phase::finished, fell + ". The calibration is saved; it can be undone.");
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
  set.stances = {{0, SupportFoot::both, std::nullopt}};
  return set;
}

} // namespace naocal
