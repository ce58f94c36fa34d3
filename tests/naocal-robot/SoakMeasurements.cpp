#include "SimulatedProcess.hpp"

#include "math/Angles.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

namespace naocal {
namespace {

/// Resident memory of this process [MB].
double residentMemory() {
  std::ifstream statm{"/proc/self/statm"};
  double all = 0, resident = 0;
  statm >> all >> resident;
  return 1e-6 * resident * double(::sysconf(_SC_PAGESIZE));
}

/// Memory that the program has allocated and not freed [MB]; unlike the resident memory without gaps of the allocator.
double allocatedMemory() {
  const struct mallinfo2 info = ::mallinfo2();
  return 1e-6 * double(info.uordblks + info.hblkhd);
}

/// Processor time of this process or thread [s].
double processorTime(int who) {
  rusage usage{};
  ::getrusage(who, &usage);
  const auto seconds = [](const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Processor time of the same computation each time [s]: other work on the computer slows it as it slows a calibration.
double referenceTime() {
  const double before = processorTime(RUSAGE_THREAD);
  volatile double sum = 0;
  for (int i = 0; i < 30'000'000; ++i) {
    sum = sum + std::sqrt(double(i));
  }
  return processorTime(RUSAGE_THREAD) - before;
}

/// A line's slope per 1000 steps with the half-width of its 95 % interval, by least squares; mean.
std::string slopeOf(const std::vector<double>& values, const char* unit) {
  const auto count = double(values.size());
  double mean = 0;
  for (const double value : values) {
    mean += value / count;
  }
  const double middle = (count - 1) / 2;
  double xx = 0, xy = 0, rest = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    xx += (double(i) - middle) * (double(i) - middle);
    xy += (double(i) - middle) * (values[i] - mean);
  }
  const double slope = xy / xx;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double residual = values[i] - mean - slope * (double(i) - middle);
    rest += residual * residual;
  }
  const double sigma = std::sqrt(rest / (count - 2) / xx);
  return fmt::format("mean {:.4g} {}, slope {:+.3g} ± {:.2g} {} per 1000 calibrations", mean, unit, 1000 * slope,
                     1000 * 1.96 * sigma, unit);
}

} // namespace

// Measurement; proves nothing. Environment: CALIBRATIONS, and SOAK_SECONDS after which no further one begins. The first
// fifth of those that were made warms up and is left out.
TEST_CASE("whether a robot that calibrates again and again grows or slows down", "[.measure]") {
  const char* wanted = std::getenv("CALIBRATIONS");
  const int most = wanted != nullptr ? std::atoi(wanted) : 20;
  const char* seconds = std::getenv("SOAK_SECONDS");
  const TimePoint end = Clock::now() + std::chrono::seconds{seconds != nullptr ? std::atoi(seconds) : 86400};
  SimulatedProcess simulated{SimulatedProcess::plan(1, radians(1))};
  std::vector<double> memory, allocated, processor, ratio, wall;
  int count = 0, finished = 0;
  for (int i = 0; i < most && Clock::now() < end; ++i) {
    ++count;
    const double processorBefore = processorTime(RUSAGE_SELF);
    const TimePoint begin = Clock::now();
    const auto state = simulated.calibrated("head");
    finished += state["phase"] == "finished" || state["phase"] == "failed" ? 1 : 0;
    std::filesystem::remove_all(simulated.folder.path() / "recordings");
    ::malloc_trim(0); // freed memory that the allocator keeps is no leak
    memory.push_back(residentMemory());
    allocated.push_back(allocatedMemory());
    processor.push_back(processorTime(RUSAGE_SELF) - processorBefore);
    wall.push_back(toSeconds(Clock::now() - begin));
    ratio.push_back(processor.back() / referenceTime());
    simulated.calibrated("undo");
    if (i % 20 == 0) {
      const auto descriptors = std::distance(std::filesystem::directory_iterator{"/proc/self/fd"}, {});
      fmt::print("{:>5}: {} {:.1f} MB, {} descriptors, {}\n", i, state["phase"].get<std::string>(), residentMemory(),
                 descriptors, state["sentence"].get<std::string>());
      std::fflush(stdout);
    }
  }
  for (std::vector<double>* values : {&memory, &allocated, &processor, &ratio, &wall}) {
    values->erase(values->begin(), values->begin() + std::ptrdiff_t(values->size() / 5));
  }
  fmt::print("{} of {} ended with a sentence\n", finished, count);
  fmt::print("resident memory: {}\n", slopeOf(memory, "MB"));
  fmt::print("allocated memory: {}\n", slopeOf(allocated, "MB"));
  fmt::print("processor time of a calibration: {}\n", slopeOf(processor, "s"));
  fmt::print("the same over that of a fixed computation: {}\n", slopeOf(ratio, "times"));
  fmt::print("wall time: {}\n", slopeOf(wall, "s"));
}

} // namespace naocal
