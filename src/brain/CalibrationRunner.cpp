#include "brain/CalibrationRunner.hpp"

#include "brain/CaptureCollector.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

namespace naocal {
namespace {

using Phase = CalibrationState::Phase;

std::string kindNames() {
  std::string names;
  for (const CalibrationKind& kind : calibrationKinds()) {
    names += fmt::format("\"{}\", ", kind.run);
  }
  return names + "\"poses\", \"undo\" or \"\"";
}

constexpr std::chrono::seconds notWorthAWord{2};

} // namespace

CalibrationRunner::CalibrationRunner(CalibrationContext context)
    : Module{"CalibrationRunner"}, jobs_{std::move(context)} {}

void CalibrationRunner::onParametersChanged() {
  kinds_ = calibrationKinds();
  const bool isGiven = run_.takeCommand(), isNew = *run_ != std::exchange(runBefore_, *run_);
  const bool counts = isGiven && (state_->isRunning() ? *run_ != state_->kind : isNew);
  if (!counts) {
    return;
  }
  const CalibrationKind* kind = findCalibrationKind(*run_);
  if (state_->isRunning()) {
    fail("The calibration was ended; the robot goes back to its stand. Nothing was changed.");
  } else if (kind != nullptr) {
    start(*kind);
  } else if (*run_ == "undo") {
    state_ = CalibrationState{.kind = *run_, .questionNumber = state_->questionNumber};
    enter(Phase::preparing, "What the last calibration saved is being taken back.");
    jobs_.undo();
  } else if (*run_ == "poses") {
    startAskedPoses();
  } else if (!run_->empty()) {
    enter(Phase::failed, fmt::format("There is no calibration \"{}\"; expected {}.", *run_, kindNames()));
  }
}

void CalibrationRunner::start(const CalibrationKind& kind) {
  kind_ = &kind;
  state_ = CalibrationState{.kind = kind.run, .questionNumber = state_->questionNumber};
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  const CalibrationContext& context = jobs_.context();
  jobs_.begin(context.recordings / fmt::format("{:%Y-%m-%d_%H-%M-%S}", fmt::gmtime(now)), kind.run);
  rounds_ = {};
  round_ = 0;
  poseTime_.reset();
  shownPoses_ = PublishedPoses{};
  shownCaptures_ = std::vector<PublishedCapture>{};
  shownOutcome_ = PublishedOutcome{};
  ask(PoseRequest::Kind::home, "The stand", {});
  enter(Phase::goingHome, "The robot goes to its stand.");
}

void CalibrationRunner::startAskedPoses() {
  if (askedPoses_->feet.empty()) {
    return enter(Phase::failed, "No poses were asked for: expected a pose file's content in the parameter \"poses\", "
                                "with poses on one foot.");
  }
  askedKind_ = {"poses", "Poses", "The poses that were asked for.", askedPoses_->feet};
  start(askedKind_);
}

void CalibrationRunner::enter(Phase phase, const std::string& sentence) {
  CalibrationState& state = state_.edit();
  state.phase = phase;
  state.sentence = sentence;
  state.question = phase == Phase::waiting ? sentence : "";
  if (!state.isRunning()) {
    state.secondsLeft.reset();
  }
}

void CalibrationRunner::fail(const std::string& sentence) {
  jobs_.abandon();
  followed_.reset(); // ignores a look request set at the same time
  ask(PoseRequest::Kind::home, "", {});
  enter(Phase::failed, sentence);
}

void CalibrationRunner::ask(PoseRequest::Kind kind, const std::string& name, std::vector<CompensatedAngles> points,
                            bool held) {
  request_.edit().write({++requests_, kind, name, std::move(points), held});
}

void CalibrationRunner::cycle() {
  state_.edit();
  if (++cycles_ % 30 == 0) { // refreshes rarely changing values once a second for late subscribers
    kinds_.edit();
    shownPoses_.edit();
    shownCaptures_.edit();
    shownOutcome_.edit();
  }
  if (cycles_ % 300 == 0) {
    runs_.edit();
  }
  watchPlayer();
  jobs_.recordSaves();
  takeResults();
  follow(*look_);
  const bool arrived = player_.request == requests_ && player_.done;
  switch (state_->phase) {
  case Phase::waiting:
    return *confirmed_ == state_->questionNumber ? go() : void();
  case Phase::goingHome:
    return arrived && player_.atHome ? arriveAtStand() : void();
  case Phase::moving:
    waitingSince_ = pictureSince_ = Clock::now();
    return arrived ? enter(Phase::collecting, state_->sentence) : void();
  case Phase::collecting:
    return collect();
  default:
    return;
  }
}

void CalibrationRunner::watchPlayer() {
  if (const PlayerState* update = playerUpdates_->take()) {
    const bool pressed = update->presses > player_.presses, fell = update->falls > player_.falls;
    player_ = *update;
    playerKnown_ = true;
    if (pressed) {
      chestPressed();
    }
    if (fell) {
      jobs_.recordFall();
    }
  }
  const bool moves = state_->kind != "undo"; // what stopped the robot earlier does not stop an undo
  if (state_->isRunning() && moves && player_.request == requests_ && !player_.reason.empty()) {
    jobs_.abandon();
    enter(Phase::failed, fmt::format("The calibration ended. {}", player_.reason));
  }
}

void CalibrationRunner::chestPressed() {
  const CalibrationKind* kind = findCalibrationKind(*chestStarts_);
  if (state_->phase == Phase::waiting) {
    go();
  } else if (!state_->isRunning() && kind != nullptr) {
    start(*kind);
  }
}

void CalibrationRunner::follow(const HeadLookRequest& look) {
  if (!followed_ || state_->isRunning()) { // ignores initial values and requests during a calibration
    followed_ = look;
  }
  const bool isLooking = requests_ > 0 && lookRequest_ == requests_;
  const bool standsOnBoth = isLooking || player_.atHome || player_.phase == PlayerState::Phase::off ||
                            player_.phase == PlayerState::Phase::fallen; // otherwise it is still moving back
  if (!playerKnown_ || player_.request != requests_ || !standsOnBoth || look == *followed_) {
    return;
  }
  if (look.active) {
    ask(PoseRequest::Kind::go, "Looking there", {turnHead(player_.home, look.yaw, look.pitch)});
    lookRequest_ = requests_;
  } else if (followed_->active) {
    ask(PoseRequest::Kind::home, "The stand", {});
  }
  followed_ = look;
}

bool CalibrationRunner::isStill(const CameraFrame& frame) {
  const auto before = previous_.find(frame.camera);
  const auto one = before == previous_.end() ? std::nullopt : toGreyImage(before->second), other = toGreyImage(frame);
  previous_[frame.camera] = frame;
  return one && other && imageDifference(*one, *other) <= *stillPicture_;
}

void CalibrationRunner::nextStep() {
  const CalibrationStep& step = rounds_[round_][step_];
  taken_ = {};
  previous_ = {};
  shownPoses_ = listPoses(static_cast<int>(round_), rounds_[round_], step_);
  if (step.question.empty()) {
    return go();
  }
  ask(PoseRequest::Kind::wait, "", {});
  state_.edit().questionNumber = std::max(state_->questionNumber, *confirmed_) + 1; // invalidates earlier answers
  enter(Phase::waiting, step.question);
}

void CalibrationRunner::go() {
  const CalibrationStep& step = rounds_[round_][step_];
  const bool home = step.points.empty();
  ask(home ? PoseRequest::Kind::home : PoseRequest::Kind::go, step.name, step.points, step.held);
  if (home) {
    enter(Phase::goingHome, "The robot goes back to its stand.");
  } else {
    enter(Phase::moving, fmt::format("{}; pictures were taken in {} of {}.", step.name, state_->pose, state_->poses));
  }
}

void CalibrationRunner::waitFor(const std::string& what) {
  if (Clock::now() - waitingSince_ > notWorthAWord) {
    state_.edit().sentence = fmt::format("{} waits until {}.", rounds_[round_][step_].name, what);
  }
}

bool CalibrationRunner::takePicture() {
  const CalibrationStep& step = rounds_[round_][step_];
  const Capture& still = picture_->capture;
  if (picture_->isNew || picture_->isMoving) {
    pictureSince_ = Clock::now();
  }
  if (picture_->isMoving || (picture_->isNew && picture_->stillFor < *settleTime_)) {
    waitFor("the robot's joints and trunk are still: they tremble, or something moves the robot");
    return false;
  }
  if (!picture_->isNew || picture_->frame.time < player_.doneAt) {
    if (Clock::now() - pictureSince_ > notWorthAWord) {
      waitFor("the cameras give pictures");
    }
    return false;
  }
  roundStart_ = roundStart_.value_or(picture_->frame.time);
  int& count = taken_[still.camera];
  if (count == step.pictures) {
    waitFor(still.camera == "top" ? "the bottom camera gives pictures" : "the top camera gives pictures");
    return false;
  }
  if (faults_.isLifted(still)) {
    fail("The robot was lifted: its feet carry nothing, and it will stand elsewhere than in the pictures before. It "
         "goes "
         "to its stand; put it down and start again. Nothing was changed.");
    return false;
  }
  if (const std::string fault = faults_.findCameraFault(picture_->frame, step.taken.pose); !fault.empty()) {
    waitFor(fault);
    return false;
  }
  if (!isStill(picture_->frame)) {
    waitFor("the picture is still: something moves before the camera");
    return false;
  }
  Capture capture = step.taken;
  capture.repeat += count++;
  capture.time = still.time;
  capture.camera = still.camera;
  std::vector<double> approach = std::move(capture.joints.approach);
  capture.joints = still.joints;
  capture.joints.approach = std::move(approach);
  capture.imu = still.imu;
  capture.fsr = still.fsr;
  faults_.note(picture_->frame, capture);
  take(capture);
  waitingSince_ = Clock::now();
  return true;
}

void CalibrationRunner::tellTimeLeft() {
  const auto left = [this](std::size_t round) {
    return std::count_if(rounds_[round].begin(), rounds_[round].end(),
                         [](const CalibrationStep& step) { return step.pictures > 0; });
  };
  CalibrationState& state = state_.edit();
  if (state.pose > 1) { // from the images of the first pose to these
    poseTime_ = toSeconds(picture_->frame.time - *roundStart_) / (state.pose - 1);
  }
  if (poseTime_) {
    const auto later = round_ == 0 && kind_ != &askedKind_ ? left(1) : 0;
    state.secondsLeft = *poseTime_ * static_cast<double>(state.poses - state.pose + later);
  }
}

void CalibrationRunner::collect() {
  const CalibrationStep& step = rounds_[round_][step_];
  if (step.pictures > 0) {
    if (!takePicture() || taken_["top"] < step.pictures || taken_["bottom"] < step.pictures) {
      return;
    }
    ++state_.edit().pose;
    tellTimeLeft();
  }
  endStep();
}

void CalibrationRunner::arriveAtStand() {
  const bool isPlanned = !rounds_[0].empty(); // otherwise this is the initial approach
  return isPlanned ? endStep() : prepare();
}

void CalibrationRunner::endStep() {
  ++step_;
  return step_ < rounds_[round_].size() ? nextStep() : endRound();
}

void CalibrationRunner::prepare() {
  enter(Phase::preparing, "The ways between the poses are being checked.");
  RoundOptions options{*repeats_, radians(*approach_), 0, *orderSeed_};
  if (kind_->feet.front() == SupportFoot::both) {
    constexpr double nearer = 0.7; // check other head angles than those calibrated with
    rounds_[0] = planHeadRound(player_.home, *yaws_, *pitches_, 1, options);
    ++options.seed;
    rounds_[1] = planHeadRound(player_.home, *yaws_, *pitches_, nearer, options);
    return startRound();
  }
  jobs_.planLegs({kind_->feet, options, *checkPoses_, player_.home, kind_ == &askedKind_ ? askedPoses_->content : ""});
}

void CalibrationRunner::startRound() {
  const CalibrationRound& round = rounds_[round_];
  step_ = 0;
  state_.edit().pose = 0;
  state_.edit().poses = static_cast<int>(
      std::count_if(round.begin(), round.end(), [](const CalibrationStep& step) { return step.pictures > 0; }));
  roundStart_.reset();
  faults_.startRound();
  jobs_.openRound(round_, header());
  nextStep();
}

void CalibrationRunner::take(const Capture& capture) {
  PublishedCapture shown{++state_.edit().captures, static_cast<int>(round_), capture.pose, capture.camera, {}, {}};
  shownCaptures_.edit().push_back(shown);
  jobs_.processCapture(round_, capture, std::move(shown), picture_->frame);
}

void CalibrationRunner::endRound() {
  ask(PoseRequest::Kind::home, "The stand", {}); // already there; releases the hold
  if (kind_ == &askedKind_) {
    return enter(Phase::finished, fmt::format("All poses were taken; what was seen lies in {} on the robot.",
                                              (jobs_.folder() / "first").string()));
  }
  if (round_ == 0) {
    enter(Phase::solving, "The captures are being solved.");
    jobs_.solve(kind_->feet.front() == SupportFoot::both);
  } else {
    enter(Phase::checking, "The second round is being compared with what was solved.");
    jobs_.check();
  }
}

void CalibrationRunner::takeResults() {
  if (const PublishedRuns* newest = jobs_.takeRuns()) {
    runs_ = *newest;
  }
  if (const std::vector<PublishedCapture>* processed = jobs_.takeProcessed()) {
    std::copy(processed->begin(), processed->end(), shownCaptures_.edit().begin());
  }
  while (auto result = jobs_.takeResult()) {
    std::visit([this](auto& one) { take(std::move(one)); }, *result);
  }
}

void CalibrationRunner::take(CalibrationJobs::PlannedRounds planned) {
  if (state_->isRunning()) {
    rounds_ = std::move(planned.rounds);
    startRound();
  }
}

void CalibrationRunner::take(CalibrationJobs::AppliedCalibration applied) {
  if (state_->isRunning()) {
    if (faults_.feltNoLoad()) {
      applied.outcome.warnings.emplace_back(
          "The foot sensors showed no load in any picture. A calibration does not use "
          "them, but a robot that is lifted meanwhile is not noticed.");
    }
    shownOutcome_ = std::move(applied.outcome);
    round_ = 1;
    startRound();
  }
}

void CalibrationRunner::take(CalibrationJobs::CheckedCalibration checked) {
  if (checked.isKept || state_->isRunning()) {
    tellError(checked.error, checked.isKept);
  }
}

void CalibrationRunner::take(CalibrationJobs::ModelDiagnosis diagnosis) {
  shownOutcome_.edit().diagnosis = std::move(diagnosis.sentence);
}

void CalibrationRunner::take(CalibrationJobs::CalibrationUndone) {
  shownOutcome_ = PublishedOutcome{};
  enter(Phase::finished, "What the last calibration saved was taken back.");
}

void CalibrationRunner::take(CalibrationJobs::JobFailure failure) {
  if (state_->kind == "undo") {
    enter(Phase::failed, fmt::format("Nothing was taken back: {}.", failure.reason));
  } else if (state_->isRunning()) {
    fail(fmt::format("The calibration ended: {}.", failure.reason));
  } else {
    enter(Phase::failed, fmt::format("{}.", failure.reason));
  }
}

void CalibrationRunner::tellError(const CalibrationRecorder::ErrorComparison& error, bool isKept) {
  state_.edit().errorBefore = error.before;
  state_.edit().errorAfter = error.after;
  const std::string errors =
      fmt::format("from {:.1f} to {:.1f} pixels in corners that were not calibrated with", error.before, error.after);
  if (isKept) {
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
                      "back, and nothing was saved. Something else is off as well: calibrate the legs, or look at the "
                      "recording with 'naocal diagnose'.",
                      errors));
  }
}

CaptureSet CalibrationRunner::header() const {
  CaptureSet set;
  set.model = jobs_.context().drawing.model;
  set.headId = jobs_.context().identity.headId;
  set.bodyId = jobs_.context().identity.bodyId;
  set.jointNames = {jointNames.begin(), jointNames.end()};
  for (const auto& [name, modelState] : *cameras_) {
    set.cameras[name] = modelState.intrinsics;
  }
  set.boards = boards_->boards;
  for (std::size_t foot = 0; foot < kind_->feet.size(); ++foot) {
    set.stances.push_back({static_cast<int>(foot), kind_->feet[foot], std::nullopt});
  }
  return set;
}

} // namespace naocal
