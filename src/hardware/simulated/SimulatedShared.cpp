#include "hardware/simulated/SimulatedShared.hpp"

#include <algorithm>

namespace naocal {

namespace {

constexpr int parts = 4;                // of a cycle, between which motion is linear
constexpr std::size_t remembered = 400; // parts: more than a second
constexpr int instants = 9;             // of an exposure

/// A quick world's time is its own, so that it is the same every time.
TimePoint beginning(const SimulatedPlan& plan) {
  return plan.pace == Pace::quick ? TimePoint{std::chrono::seconds{1000}} : std::chrono::steady_clock::now();
}

std::chrono::nanoseconds half(Seconds duration) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(duration / 2);
}

/// Between two postures; the world's axes.
Eigen::Isometry3d between(const Eigen::Isometry3d& one, const Eigen::Isometry3d& other, double share) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond{one.linear()}.slerp(share, Eigen::Quaterniond{other.linear()});
  Eigen::Isometry3d result{turn};
  result.translation() = (1 - share) * one.translation() + share * other.translation();
  return result;
}

} // namespace

SimulatedShared::SimulatedShared(const Robot& robotDrawing, const SimulatedPlan& simulatedPlan)
    : plan{simulatedPlan}, drawing{robotDrawing}, errors{drawnErrors(robotDrawing, simulatedPlan)}, body{robotDrawing,
                                                                                                         simulatedPlan,
                                                                                                         errors},
      now{beginning(simulatedPlan)}, cameras{SimulatedCamera{CameraName::top, simulatedPlan, now},
                                             SimulatedCamera{CameraName::bottom, simulatedPlan,
                                                             now + half(simulatedPlan.cameras.period)}} {
  remember();
}

void SimulatedShared::remember() {
  history_.push_back({now, body.joints(), body.worldFromTorso()});
  if (history_.size() > remembered) {
    history_.pop_front();
  }
}

std::optional<SimulatedShared::Moment> SimulatedShared::momentAt(TimePoint time) const {
  if (time < history_.front().time || time > history_.back().time) {
    return std::nullopt;
  }
  const auto after = std::lower_bound(history_.begin() + (history_.size() > 1), history_.end(), time,
                                      [](const Moment& moment, TimePoint when) { return moment.time < when; });
  const Moment& other = *after;
  const Moment& one = history_.size() > 1 ? *(after - 1) : other;
  const double share = time == one.time ? 0 : Seconds{time - one.time} / Seconds{other.time - one.time};
  return Moment{time, one.joints + share * (other.joints - one.joints),
                between(one.worldFromTorso, other.worldFromTorso, share)};
}

void SimulatedShared::advance() {
  for (int part = 0; part < parts; ++part) {
    while (!commands.empty() && commands.front().first <= now) {
      body.command(commands.front().second);
      commands.pop_front();
    }
    body.advance(cycle / parts);
    now += cycle / parts;
    remember();
  }
  for (std::size_t camera = 0; camera < cameras.size(); ++camera) {
    while (const auto begins = cameras[camera].arrivedBy(now)) {
      expose(camera, *begins);
    }
  }
}

void SimulatedShared::expose(std::size_t camera, TimePoint begins) {
  std::vector<Eigen::Isometry3d> worldFromCamera;
  const std::size_t mount = drawing.cameraIndex(toString(CameraName(camera))).value();
  for (int instant = 0; instant < instants; ++instant) {
    const TimePoint time = begins + cameras[camera].span() * instant / (instants - 1);
    const Moment moment = momentAt(std::clamp(time, history_.front().time, history_.back().time)).value();
    worldFromCamera.push_back(body.worldFromCamera(mount, moment.joints, moment.worldFromTorso));
  }
  cameras[camera].deliver(worldFromCamera);
}

} // namespace naocal
