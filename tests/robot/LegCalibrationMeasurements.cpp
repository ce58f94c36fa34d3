#include "LegCalibrationTruth.hpp"

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

// Measures; proves nothing. KIND, FIRST and LAST seed, PLAY in degrees are taken from the environment.
TEST_CASE("how well simulated robots calibrate their legs", "[.measure]") {
  const std::string kind = orElse("KIND", "left leg");
  std::vector<double> before, after, seconds;
  std::map<std::string, std::pair<int, int>> within; // by joint: of how many
  int ended = 0, robots = 0;
  for (int seed = std::atoi(orElse("FIRST", "1")); seed <= std::atoi(orElse("LAST", "20")); ++seed) {
    const SimulatedPlan plan =
        SimulatedProcess::plan(std::uint64_t(seed), radians(5), radians(std::atof(orElse("PLAY", "0.5"))));
    SimulatedProcess simulated{plan};
    const auto state = simulated.calibrated(kind);
    ++robots;
    fmt::print("{:3} {} after {:.0f} s: {}\n", seed, state["phase"].get<std::string>(),
               state.value("robotSeconds", 0.0), state.value("sentence", ""));
    if (!std::filesystem::exists(simulated.folder.path() / "recordings") ||
        !std::filesystem::exists(simulated.recording() / "result.json")) {
      continue;
    }
    const StoredResult result = readResult(simulated.recording() / "result.json");
    const auto json = SimulatedProcess::Json::parse(fileContent(simulated.recording() / "result.json"));
    const CaptureSet set = readCaptureSet(simulated.recording()).set;
    const LegCalibrationTruth truth{simulated.drawing, simulated.world.errors(), plan.servos};
    for (const SupportFoot foot : {SupportFoot::left, SupportFoot::right}) {
      if (kind != (foot == SupportFoot::left ? "right leg" : "left leg")) {
        before.push_back(truth.floorError(foot, {}));
        after.push_back(truth.floorError(foot, result));
        fmt::print("    floor point at 2 m: from {:.1f} to {:.1f} cm\n", 100 * before.back(), 100 * after.back());
      }
    }
    for (const auto& effect : json["effects"]) {
      if (effect["effect"] == "jointOffset") {
        const std::size_t joint = *simulated.drawing.jointIndex(effect["at"].get<std::string>());
        const double shown = truth.shownTooMuch(joint, set);
        const auto& unknown = effect["unknowns"]["o"];
        const double low = unknown["interval95"][0], high = unknown["interval95"][1];
        auto& [inside, all] = within[effect["at"]];
        inside += low <= shown && shown <= high;
        ++all;
        fmt::print("    {:14} {:7.2f} found {:7.2f} +- {:.2f} degrees{}\n", effect["at"].get<std::string>(),
                   degrees(shown), degrees(unknown["value"].get<double>()), degrees((high - low) / 2),
                   low <= shown && shown <= high ? "" : " <<<");
      }
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
