#include "RobotV6.hpp"
#include "poses/candidates/PoseSampler.hpp"
#include "poses/criteria/PoseCriterion.hpp"
#include "simulation/SimulationPlan.hpp"

#include <benchmark/benchmark.h>
#include <sys/resource.h>

// Cost of pose candidates on all cores: generating, validating and scoring 10^5 to 10^7 (with fitted complexity), and
// selecting 8 poses from a million candidates. Run by hand; 10^7 take minutes.

namespace naocal {
namespace {

PoseOptions options(std::int64_t candidates) {
  PoseOptions result;
  result.maxAttempts = static_cast<std::size_t>(candidates);
  result.sampling = SamplingMethod::even;
  return result;
}

const PlanningScene& scene() {
  static const PoseOptions wanted;
  static const SimulationPlan plan;
  static const PlanningScene scene{v6(), SupportFoot::left, plan.boards, plan.cameras, wanted.sight};
  return scene;
}

/// Peak memory of the process so far [MB].
double mostMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void generateValidateScore(benchmark::State& state) {
  for (auto _ : state) {
    const PoseCandidates candidates = samplePoses(v6(), scene(), options(state.range(0)));
    benchmark::DoNotOptimize(computeInformation(v6(), scene(), candidates.attitudes, Noise{}));
    state.counters["reachable"] = static_cast<double>(candidates.sieve.reachable);
    state.counters["stable"] = static_cast<double>(candidates.sieve.stable);
    state.counters["seeing"] = static_cast<double>(candidates.sieve.seeing);
  }
  state.counters["MB"] = mostMemory();
  state.SetComplexityN(state.range(0));
}
BENCHMARK(generateValidateScore)
    ->RangeMultiplier(10)
    ->Range(100'000, 10'000'000)
    ->Complexity(benchmark::oN)
    ->Iterations(1)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kSecond);

void selectEight(benchmark::State& state) {
  const PoseCandidates candidates = samplePoses(v6(), scene(), options(state.range(0)));
  const PoseCriterion judge{v6(), scene(), scene().joints(), Criterion::worst};
  for (auto _ : state) {
    std::vector<Eigen::MatrixXd> parts = computeInformation(v6(), scene(), candidates.attitudes, Noise{});
    for (Eigen::MatrixXd& part : parts) {
      part = judge.relevantInformation(part);
    }
    benchmark::DoNotOptimize(selectPoses(judge, judge.prior(), parts, 8));
  }
}
BENCHMARK(selectEight)->Arg(1'000'000)->Iterations(1)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kSecond);

} // namespace
} // namespace naocal

BENCHMARK_MAIN();
