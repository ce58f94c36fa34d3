#include "diagnosis/Questioned.hpp"

#include "diagnosis/Diagnosis.hpp"
#include "math/Parallel.hpp"

#include <benchmark/benchmark.h>

// Run time of a diagnosis of 30 poses with two cameras and three pictures each: calibration alone, one pass of the
// score tests, and the whole diagnosis of a robot with no, one and two missing effects (one, two and three rungs). Run
// by hand.

namespace naocal {
namespace {

constexpr std::size_t poses = 30;

const Questioned& sound() {
  static const Questioned questioned{simulatedSet(poses, 1), true};
  return questioned;
}

/// Scales the readings of joints by 1 + gain.
CaptureSet withGains(const std::vector<std::pair<std::string, double>>& gains) {
  CaptureSet set = simulatedSet(poses, 1);
  for (const auto& [joint, gain] : gains) {
    const auto index = std::find(set.jointNames.begin(), set.jointNames.end(), joint) - set.jointNames.begin();
    for (Capture& capture : set.captures) {
      capture.joints.measured[static_cast<std::size_t>(index)] *= 1 + gain;
    }
  }
  return set;
}

void calibration(benchmark::State& state) {
  const Questioned& robot = sound(); // simulated outside the timed loop
  for (auto _ : state) {
    benchmark::DoNotOptimize(calibrate(robot.measurements, robot.model));
  }
}

void scorePass(benchmark::State& state) {
  const std::vector<Term> testable = sound().testable();
  for (auto _ : state) {
    const CandidateTests candidateTests{
        {sound().measurements, sound().model, sound().fit}, testable, {.draws = 0, .map = false}};
    benchmark::DoNotOptimize(candidateTests.evidence().pValue);
  }
  state.counters["candidates"] = static_cast<double>(testable.size());
}

void scorePassWithMapAndAlarm(benchmark::State& state) {
  const std::vector<Term> testable = sound().testable();
  for (auto _ : state) {
    const CandidateTests candidateTests{{sound().measurements, sound().model, sound().fit}, testable};
    benchmark::DoNotOptimize(candidateTests.evidence().pValue);
  }
}

void wholeDiagnosis(benchmark::State& state, const std::vector<std::pair<std::string, double>>& gains) {
  const CaptureSet set = withGains(gains);
  const Measurements measurements = buildMeasurements({set}, loadRobot(configurationDirectory(), "V6"));
  std::size_t rungs = 0;
  for (auto _ : state) {
    rungs = diagnose(measurements).steps.size();
  }
  state.counters["rungs"] = static_cast<double>(rungs);
}

BENCHMARK(calibration)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(scorePass)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(scorePassWithMapAndAlarm)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(wholeDiagnosis, sound, {})->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(wholeDiagnosis, flaw, {{"LKneePitch", 0.01}})->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(wholeDiagnosis, twoFlaws, {{"LKneePitch", 0.01}, {"LHipRoll", 0.03}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace naocal

int main(int argc, char** argv) {
  naocal::tuneAllocator(); // as in naocal
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
