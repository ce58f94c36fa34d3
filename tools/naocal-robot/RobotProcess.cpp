#include "RobotProcess.hpp"

#include "brain/CalibrationInputs.hpp"
#include "framework/configuration/ConfigurationLayers.hpp"
#include "framework/core/ModuleConfiguration.hpp"
#include "io/Files.hpp"
#include "motion/MotionModules.hpp"
#include "runs/RunFolder.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

constexpr int motionPriority = 30; // below the firmware's threads, above all ordinary ones

/// The robot's names, with the location from the options or sdk.json.
RobotNames namesOf(const RobotIdentity& identity, const RobotProcessOptions& options) {
  RobotNames names = findRobotNames(options.configuration, identity.headId, identity.bodyId);
  names.location = options.location;
  const Overlay sdk{layerFiles({options.configuration, options.state}, "sdk.json", RobotPart::none, {})};
  if (names.location.empty() && sdk.merged->contains("location")) {
    const auto& location = (*sdk.merged)["location"];
    if (!location.is_string()) {
      throw ConfigurationError{"sdk.json: location: expected the name of a folder in the configuration's location"};
    }
    names.location = location;
  }
  const auto folder = options.configuration / "location" / names.location;
  if (!std::filesystem::is_directory(folder)) {
    throw ConfigurationError{
        fmt::format("there is no location \"{}\": expected a folder {}", names.location, folder.string())};
  }
  return names;
}

/// Its runs are recorded in the state folder; nowhere without one, as the configuration is shipped.
RunRecording runsOf(const RobotIdentity& identity, const RobotNames& names, const RobotProcessOptions& options,
                    const Log& log) {
  return {options.state.empty() ? options.state : runsIn(options.state),
          {names.body, names.head, identity.bodyId, identity.headId},
          log};
}

} // namespace

RobotProcess::RobotProcess(RobotInterface& robot, CameraInterface& cameras, const Robot& drawing,
                           const RobotIdentity& identity, const RobotProcessOptions& options, Log log)
    : robot_{robot}, cameras_{cameras}, options_{options}, log_{std::move(log)},
      configuration_{{options.configuration, options.state}, namesOf(identity, options), writeAtomically, log_} {
  addMotionModules(motion_, robot, drawing, ending_);
  const RobotNames names = namesOf(identity, options);
  addBrainModules(brain_, cameras,
                  {drawing, identity, configuration_, options.configuration, options.recordings,
                   runsOf(identity, names, options, log_)});
  if (options.replay != nullptr) {
    replayed_ = &brain_.add<ReplayedCalibration>(drawing, *options.replay, options.recordings,
                                                 loadCalibrationModel(options.configuration, drawing));
  }
  database_.emplace(std::vector<Thread*>{&motion_, &brain_});
  configuration_.mount("tuhhSDK.base", "sdk.json", RobotPart::none);
  configuration_.publish("tuhhSDK.base", "NaoInfo.headName", names.head);
  configuration_.publish("tuhhSDK.base", "NaoInfo.bodyName", names.body);
  // extension: HULKs' robots do not publish ids
  configuration_.publish("tuhhSDK.base", "NaoInfo.headId", identity.headId);
  configuration_.publish("tuhhSDK.base", "NaoInfo.bodyId", identity.bodyId);
  configuration_.publish("tuhhSDK.base", "location", names.location);
  for (Thread* thread : {&motion_, &brain_}) {
    for (const std::string& unknown : configureModules(*thread, configuration_)) {
      log_(unknown);
    }
  }
  SocketSettings sockets =
      options.sockets ? *options.sockets : readSocketSettings({options.configuration, options.state}, names.head);
  if (options.basePort) {
    sockets.debugPort = static_cast<std::uint16_t>(*options.basePort + 1);
    sockets.configPort = static_cast<std::uint16_t>(*options.basePort + 2);
  }
  if (options.onlyHere) {
    sockets.access = {};
  }
  sockets_.emplace(sockets, std::vector<Thread*>{&motion_, &brain_}, configuration_,
                   Clock::now() - std::chrono::seconds{2}, log_);
}

RobotProcess::~RobotProcess() {
  stop();
}

void RobotProcess::start(std::function<void(std::string_view)> failed) {
  failed_ = std::move(failed);
  moves_ = true;
  motionThread_ = std::jthread{[this](const std::stop_token& stop) {
    const std::string refused = options_.realTime ? requestRealTimePriority(motionPriority) : "";
    if (!refused.empty()) {
      requestShortSlice();
      log_(fmt::format("The motion thread runs without real-time priority, which the system refuses: {}.", refused));
    }
    run(motion_, stop, [this] { return robot_.hasEnded(); });
    moves_ = false;
  }};
  brainThread_ = std::jthread{[this](const std::stop_token& stop) {
    letOthersFinish();
    run(brain_, stop, [this] { return cameras_.hasEnded(); });
  }};
}

void RobotProcess::run(Thread& thread, const std::stop_token& stop, const std::function<bool()>& ended) {
  try {
    while (!stop.stop_requested() && !ended()) {
      thread.cycle();
    }
    if (!stop.stop_requested()) {
      failed_("");
    }
  } catch (const std::exception& error) {
    failed_(fmt::format("The {} thread has ended: {}", thread.name(), error.what()));
  }
}

void RobotProcess::stop() {
  motionThread_.request_stop();
  brainThread_.request_stop();
  for (std::jthread* thread : {&motionThread_, &brainThread_}) {
    if (thread->joinable()) {
      thread->join();
    }
  }
  motion_.end();
  brain_.end();
}

bool RobotProcess::goToStand(std::chrono::milliseconds most) {
  constexpr std::chrono::milliseconds glance{10};
  ending_.asked = true;
  for (auto waited = glance; waited <= most && moves_; waited += glance) {
    std::this_thread::sleep_for(glance);
    if (ending_.atRest) {
      return true;
    }
  }
  return false;
}

} // namespace naocal
