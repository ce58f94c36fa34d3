#include "framework/core/Thread.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace naocal {

/// Measures a thread's CycleTimes; the first module of every thread.
class CycleClock final : public Module {
public:
  CycleClock() : Module{"CycleClock"} {}
  void cycle() override; // publishes the counts up to the previous cycle

  /// Counts a cycle: measurement time `start`, arrival of the measurements `arrival`, end of work `end`.
  void count(TimePoint start, TimePoint arrival, TimePoint end);

private:
  CycleTimes counted_;
  std::optional<TimePoint> lastStart_;
  Production<CycleTimes> times_{*this, "cycleTimes"};
  Production<double> measured_{*this, "measuredCycleTime"}; // [s]
};

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
  times.work = toSeconds(end - arrival);
  times.longestWork = std::max(times.longestWork, times.work);
  times.meanWork += (times.work - times.meanWork) / double(times.cycles);
  if (lastStart_) {
    times.period = toSeconds(start - *lastStart_);
    times.longestPeriod = std::max(times.longestPeriod, times.period);
    times.meanPeriod += (times.period - times.meanPeriod) / double(times.cycles - 1);
  }
  lastStart_ = start;
}

Thread::Thread(std::string name, RobotPart part) : name_{std::move(name)}, part_{part} {
  clock_ = &add<CycleClock>();
}

Module& Thread::add(std::unique_ptr<Module> module) {
  modules_.push_back(std::move(module));
  productions_ = productions();
  return *modules_.back();
}

std::vector<AnyProduction*> Thread::productions() const {
  std::vector<AnyProduction*> all;
  for (const auto& module : modules_) {
    all.insert(all.end(), module->productions().begin(), module->productions().end());
  }
  return all;
}

void Thread::sort(const std::vector<std::size_t>& order) {
  std::vector<std::unique_ptr<Module>> sorted;
  for (const std::size_t index : order) {
    sorted.push_back(std::move(modules_[index]));
  }
  modules_ = std::move(sorted);
}

void Thread::postChange(Module& module, const AnyParameter& parameter, std::function<void()> apply) {
  std::list<Change> freed; // after unlocking
  const std::lock_guard lock{changesMutex_};
  freed.swap(applied_);
  if (changes_.size() >= mostChanges) {
    const auto last = std::find_if(changes_.rbegin(), changes_.rend(),
                                   [&](const Change& change) { return change.parameter == &parameter; });
    if (last != changes_.rend()) {
      last->apply = std::move(apply);
      return;
    }
  }
  changes_.push_back({&module, &parameter, std::move(apply)});
}

void Thread::applyChanges() {
  {
    const std::unique_lock lock{changesMutex_, std::try_to_lock};
    if (!lock.owns_lock()) {
      return; // a change is being posted; the next cycle applies it
    }
    applied_.splice(applied_.end(), applying_);
    const auto end = std::next(changes_.begin(), std::ptrdiff_t(std::min(changes_.size(), changesPerCycle)));
    applying_.splice(applying_.end(), changes_, changes_.begin(), end);
  }
  for (Change& change : applying_) { // one by one: a module sees each of two values that arrive together
    change.apply();
    change.module->onParametersChanged();
  }
}

void Thread::cycle() {
  applyChanges();
  for (AnyProduction* production : productions_) {
    production->beginCycle();
  }
  TimePoint arrival = Clock::now();
  TimePoint start = arrival;
  for (const auto& module : modules_) {
    module->cycle();
    if (const auto time = module->takeCycleTime()) {
      start = *time;
      arrival = Clock::now();
    }
  }
  clock_->count(start, arrival, Clock::now());
  if (listener_ != nullptr) {
    listener_->onCycleEnd(start, productions_);
  }
}

void Thread::end() {
  for (const auto& module : modules_) {
    module->onThreadEnd();
  }
}

std::string requestRealTimePriority(int priority) {
  const sched_param parameters{.sched_priority = priority};
  const int error = ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &parameters);
  return error == 0 ? std::string{} : std::strerror(error);
}

void requestShortSlice() {
  struct { // sched_attr of the kernel, in its first size; glibc before 2.41 declares none
    std::uint32_t size, policy;
    std::uint64_t flags;
    std::int32_t nice;
    std::uint32_t priority;
    std::uint64_t runtime, deadline, period; // runtime: the slice [ns]
  } attributes{.size = 48,
               .policy = SCHED_OTHER,
               .flags = 0,
               .nice = ::getpriority(PRIO_PROCESS, id_t(::gettid())),
               .priority = 0,
               .runtime = 500'000,
               .deadline = 0,
               .period = 0};
  static_assert(sizeof attributes == 48);
  ::syscall(SYS_sched_setattr, 0, &attributes, 0);
}

void letOthersFinish() {
  const sched_param parameters{}; // keeps the niceness
  ::sched_setscheduler(0, SCHED_BATCH, &parameters);
}

void runInBackground() {
  letOthersFinish();
  ::setpriority(PRIO_PROCESS, id_t(::gettid()), backgroundNiceness);
  cpu_set_t processors;
  if (::sched_getaffinity(0, sizeof processors, &processors) != 0 || CPU_COUNT(&processors) < 2) {
    return;
  }
  int last = CPU_SETSIZE - 1;
  while (!CPU_ISSET(last, &processors)) {
    --last;
  }
  CPU_CLR(last, &processors);
  ::sched_setaffinity(0, sizeof processors, &processors);
}

} // namespace naocal
