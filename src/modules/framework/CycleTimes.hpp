#pragma once

#include "framework/Module.hpp"
#include "framework/Production.hpp"

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// How regularly and how long a thread works, over all its cycles.
struct CycleTimes {
  std::uint64_t cycles = 0;
  double period = 0, meanPeriod = 0, longestPeriod = 0; // from one cycle's measurements to the next ones [s]
  double work = 0, meanWork = 0, longestWork = 0;       // from the measurements' arrival to the end of the cycle [s]
};
void to_json(nlohmann::json& out, const CycleTimes& times);

/// Keeps a thread's CycleTimes; each thread has one as its first module.
class CycleClock final : public Module {
public:
  CycleClock() : Module{"CycleClock"} {}
  void cycle() override; // publishes what was counted up to the cycle before

  /// Counts a cycle whose measurements had the time `start`, arrived at `arrival` and were worked on until `end`.
  void count(TimePoint start, TimePoint arrival, TimePoint end);

private:
  CycleTimes counted_;
  std::optional<TimePoint> lastStart_;
  Production<CycleTimes> times_{*this, "cycleTimes"};
  Production<double> measured_{*this, "measuredCycleTime"}; // [s]
};

} // namespace naocal
