#include "SolveProblems.hpp"

#include "calibration/Calibration.hpp"
#include "calibration/Initialization.hpp"
#include "estimation/ModelBuilder.hpp"
#include "estimation/Residuals.hpp"
#include "math/LevenbergMarquardt.hpp"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <deque>
#include <fmt/core.h>
#include <fstream>
#include <functional>
#include <map>
#include <string>

namespace naocal {
namespace {

constexpr Noise pixelOnly{.pixel = 0.3, .encoder = 0, .pose = 0};

/// A problem prepared for the modules' solver.
struct Prepared {
  Prepared(const Robot& robot, const CaptureSet& set, const std::vector<std::string>& without,
           const std::vector<std::string>& with = {})
      : measurements{buildMeasurements({set}, robot)}, model{buildModel(measurements, with, without)} {}
  Measurements measurements;
  Model model;
};

Eigen::VectorXd searched(const Residuals& residuals, const Eigen::VectorXd& start) {
  return levenbergMarquardt(residuals, residuals.startState(start)).value().state.unknowns;
}

Eigen::VectorXd zero(const Model& model) {
  return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.unknownCount()));
}

Eigen::VectorXd solved(const Prepared& problem, const Noise& noise) {
  return searched(Residuals{problem.measurements, problem.model, noise}, zero(problem.model));
}

/// Reporter that stores CPU times instead of printing them: name -> times, one per problem [us].
class Times : public benchmark::BenchmarkReporter {
public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      times_[run.run_name.function_name].push_back(run.GetAdjustedCPUTime());
    }
  }
  const std::vector<double>& operator[](const std::string& name) const { return times_.at(name); }

private:
  std::map<std::string, std::vector<double>> times_;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

void time(const std::string& name, const std::function<Eigen::VectorXd()>& solve) {
  benchmark::RegisterBenchmark(name.c_str(), [solve](benchmark::State& state) {
    for (auto _ : state) {
      benchmark::DoNotOptimize(solve());
    }
  })->Unit(benchmark::kMicrosecond);
}

double peakMemory() { // of the process so far [MB]
  std::ifstream status{"/proc/self/status"};
  for (std::string word; status >> word;) {
    if (word == "VmHWM:") {
      double kilobytes = 0;
      status >> kilobytes;
      return kilobytes / 1e3;
    }
  }
  return 0;
}

/// The reference solvers.
const std::map<std::string, std::function<Eigen::VectorXd(const PlainProblem&)>> others{
    {"thesis", solvedByDifferences},
    {"Ceres Cholesky", [](const PlainProblem& plain) { return solvedByCeres(plain, CeresSolver::normalCholesky); }},
    {"Ceres QR", [](const PlainProblem& plain) { return solvedByCeres(plain, CeresSolver::qr); }}};

/// Whether all solvers end within 1e-6 rad of our minimum.
bool sameMinimum(const Prepared& problem, const PlainProblem& plain) {
  const Eigen::VectorXd ours = solved(problem, pixelOnly);
  bool same = true;
  for (const auto& [name, solve] : others) {
    const double difference = (solve(plain) - ours).cwiseAbs().maxCoeff();
    if (!(difference < 1e-6)) {
      fmt::print(stderr, "{} ends {:.1e} rad from our minimum; expected at most 1e-6\n", name, difference);
      same = false;
    }
  }
  return same;
}

void printTable(const Times& times) {
  const std::vector<double>& ours = times["ours"];
  fmt::print("\n8 poses x 4 boards x 20 corners, 8 offsets: medians over {} problems\n", ours.size());
  fmt::print("| solver | time [us] | time in units of ours | smallest | largest |\n|---|---|---|---|---|\n");
  for (const auto& [name, what] :
       std::map<std::string, std::string>{{"ours", "ours, pixel noise"},
                                          {"ours search", "ours, without preparing the residuals"},
                                          {"ours encoder", "ours, encoder noise marginalised"},
                                          {"thesis", "Eigen's Levenberg-Marquardt, central differences"},
                                          {"Ceres Cholesky", "Ceres, automatic, DENSE_NORMAL_CHOLESKY"},
                                          {"Ceres QR", "Ceres, automatic, DENSE_QR"}}) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      ratios.push_back(times[name][i] / ours[i]);
    }
    const auto [smallest, largest] = std::minmax_element(ratios.begin(), ratios.end());
    fmt::print("| {} | {:.0f} | {:.2f} | {:.2f} | {:.2f} |\n", what, median(times[name]), median(ratios), *smallest,
               *largest);
  }
}

} // namespace
} // namespace naocal

/// Prints the search's run time relative to library solvers, within this run. Exit code 1: the solvers do not end in
/// the same minimum. Takes options of Google Benchmark, such as --benchmark_min_time=0.01.
int main(int argc, char** argv) {
  using namespace naocal;
  benchmark::Initialize(&argc, argv);
  const Robot robot = loadRobot(configurationDirectory(), "V6");

  const Prepared full{robot, fullSet(robot, 1), {}};
  const Eigen::VectorXd nominal = initializePlacements(full.measurements, full.model, zero(full.model));
  time("full search", [&] { return searched(Residuals{full.measurements, full.model, Noise{}}, nominal); });
  const Prepared driven{robot, fullSet(robot, 1), {}, {"elasticity@*", "backlash@*"}};
  const Eigen::VectorXd drivenNominal = initializePlacements(driven.measurements, driven.model, zero(driven.model));
  const Residuals fullResiduals{full.measurements, full.model, Noise{}},
      drivenResiduals{driven.measurements, driven.model, Noise{}};
  time("full step", [&] { return fullResiduals.linearize(fullResiduals.startState(nominal))->gradient; });
  time("driven step", [&] { return drivenResiduals.linearize(drivenResiduals.startState(drivenNominal))->gradient; });
  time("driven search", [&] { return searched(drivenResiduals, drivenNominal); });
  time("full calibration", [&] { return calibrate(full.measurements, full.model).unknowns; });
  Times fullTimes;
  benchmark::RunSpecifiedBenchmarks(&fullTimes);
  benchmark::ClearRegisteredBenchmarks();
  fmt::print("24 poses x 2 cameras x 3 samples, {} corners, {} unknowns\n", full.measurements.cornerCount,
             full.model.unknownCount());
  fmt::print("one search: {:.2f} ms; whole calibration: {:.1f} ms; peak memory: {:.1f} MB\n",
             median(fullTimes["full search"]) / 1e3, median(fullTimes["full calibration"]) / 1e3, peakMemory());
  fmt::print("with elasticity and backlash of every joint ({} unknowns): one linearisation takes {:.2f} times as long, "
             "one search {:.2f} times\n",
             driven.model.unknownCount(), median(fullTimes["driven step"]) / median(fullTimes["full step"]),
             median(fullTimes["driven search"]) / median(fullTimes["full search"]));

  bool same = true;
  std::deque<OffsetProblem> problems; // deques: later elements keep references to them
  std::deque<Prepared> prepared;
  std::deque<Residuals> ready;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    problems.push_back(offsetProblem(robot, seed));
    prepared.emplace_back(robot, problems.back().set, std::vector<std::string>{"cameraRotation@*"});
    const Prepared& problem = prepared.back();
    const PlainProblem& plain = problems.back().plain;
    ready.emplace_back(problem.measurements, problem.model, pixelOnly);
    same &= sameMinimum(problem, plain);
    time("ours", [&] { return solved(problem, pixelOnly); });
    time("ours search", [&problem, &residuals = ready.back()] { return searched(residuals, zero(problem.model)); });
    time("ours encoder", [&] { return solved(problem, Noise{.pixel = 0.3}); });
    for (const auto& [name, solve] : others) {
      time(name, [&plain, &solve = solve] { return solve(plain); });
    }
  }
  Times times;
  benchmark::RunSpecifiedBenchmarks(&times);
  printTable(times);
  return same ? 0 : 1;
}
