#include "LegCalibrationTruth.hpp"

#include "dialects/SavedCalibration.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fmt/format.h>

namespace naocal {
namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

const char* orElse(const char* variable, const char* otherwise) {
  const char* value = std::getenv(variable);
  return value ? value : otherwise;
}

} // namespace

// Measurement; proves nothing. Environment: KIND, FIRST and LAST seed, PLAY [degrees], the gears' FRICTION [Nm], and
// KEEP, a folder for recordings.
TEST_CASE("how well simulated robots calibrate their legs", "[.measure]") {
  const std::string kind = orElse("KIND", "left leg");
  std::vector<double> before, after, seconds;
  std::map<std::string, std::pair<int, int>> within; // by joint: inside, total
  int ended = 0, robots = 0;
  for (int seed = std::atoi(orElse("FIRST", "1")); seed <= std::atoi(orElse("LAST", "20")); ++seed) {
    SimulatedPlan plan =
        SimulatedProcess::plan(std::uint64_t(seed), radians(5), radians(std::atof(orElse("PLAY", "0.5"))));
    plan.servos.gearFriction = std::atof(orElse("FRICTION", "0.1"));
    SimulatedProcess simulated{plan};
    const auto state = simulated.calibrated(kind);
    ++robots;
    fmt::print("{:3} {} after {:.0f} s: {}\n", seed, state["phase"].get<std::string>(),
               state.value("robotSeconds", 0.0), state.value("sentence", ""));
    if (!std::filesystem::exists(simulated.recording())) {
      continue;
    }
    if (const char* keep = std::getenv("KEEP")) {
      const auto kept = std::filesystem::path{keep} / std::to_string(seed);
      std::filesystem::copy(simulated.recording(), kept, std::filesystem::copy_options::recursive);
      SimulatedProcess::Json errors;
      for (std::size_t joint = 0; joint < simulated.drawing.joints.size(); ++joint) {
        errors[simulated.drawing.joints[joint].name] = {
            {"offset", simulated.world.errors().robot.jointOffsets[static_cast<Eigen::Index>(joint)]},
            {"play", simulated.world.errors().play[joint]}};
      }
      writeAtomically(kept / "errors.json", errors.dump(1));
    }
    if (!std::filesystem::exists(simulated.recording() / "offsets.json")) {
      continue;
    }
    const auto offsets = SimulatedProcess::Json::parse(readFile(simulated.recording() / "offsets.json"));
    const CaptureSet set = readCaptureSet(simulated.recording()).set;
    const LegCalibrationTruth truth{simulated.drawing, simulated.world.errors(), plan.servos};
    for (const SupportFoot foot : {SupportFoot::left, SupportFoot::right}) {
      if (kind != (foot == SupportFoot::left ? "right leg" : "left leg")) {
        before.push_back(truth.floorError(foot, {}));
        after.push_back(truth.floorError(foot, readConfiguredCalibration(simulated.process->configuration())));
        fmt::print("    floor point at 2 m: from {:.1f} to {:.1f} cm\n", 100 * before.back(), 100 * after.back());
      }
    }
    for (const auto& [name, found] : offsets.items()) {
      const double shown = truth.shownTooMuch(*simulated.drawing.jointIndex(name), set);
      const double value = found["offset"], reach = 1.96 * found["sigma"].get<double>();
      auto& [inside, all] = within[name];
      const bool holds = std::abs(shown - value) <= reach;
      inside += holds;
      ++all;
      fmt::print("    {:14} {:7.2f} found {:7.2f} +- {:.2f} degrees{}\n", name, degrees(shown), degrees(value),
                 degrees(reach), holds ? "" : " <<<");
    }
    ended += state["phase"] == "finished";
    seconds.push_back(state["robotSeconds"]);
    std::fflush(stdout);
  }
  int inside = 0, all = 0;
  for (const auto& [joint, counts] : within) {
    fmt::print("{:14} {} of {} within their interval\n", joint, counts.first, counts.second);
    inside += counts.first;
    all += counts.second;
  }
  fmt::print("{} of {} robots finished; floor point at 2 m from {:.1f} to {:.2f} cm (medians); {:.1f} % of {} offsets "
             "within their 95 % interval; {:.0f} s of robot time (median)\n",
             ended, robots, 100 * median(before), 100 * median(after), 100.0 * inside / std::max(1, all), all,
             median(seconds));
}

} // namespace naocal
