#include "framework/CycleTimes.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace naocal {

void to_json(nlohmann::json& out, const CycleTimes& times) {
  out = {{"cycles", times.cycles},
         {"period", times.period},
         {"meanPeriod", times.meanPeriod},
         {"longestPeriod", times.longestPeriod},
         {"work", times.work},
         {"meanWork", times.meanWork},
         {"longestWork", times.longestWork}};
}

void CycleClock::cycle() {
  times_ = counted_;
  measured_ = counted_.period;
}

void CycleClock::count(TimePoint start, TimePoint arrival, TimePoint end) {
  CycleTimes& times = counted_;
  ++times.cycles;
  times.work = seconds(end - arrival);
  times.longestWork = std::max(times.longestWork, times.work);
  times.meanWork += (times.work - times.meanWork) / double(times.cycles);
  if (lastStart_) {
    times.period = seconds(start - *lastStart_);
    times.longestPeriod = std::max(times.longestPeriod, times.period);
    times.meanPeriod += (times.period - times.meanPeriod) / double(times.cycles - 1);
  }
  lastStart_ = start;
}

} // namespace naocal
