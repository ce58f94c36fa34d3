#pragma once

#include "framework/configuration/ConfigurationLayers.hpp"
#include "framework/core/Module.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// Period and work time of a thread, last, mean and maximum over all cycles.
struct CycleTimes {
  std::uint64_t cycles = 0;
  double period = 0, meanPeriod = 0, longestPeriod = 0; // between the measurement times of successive cycles [s]
  double work = 0, meanWork = 0, longestWork = 0;       // from arrival of the measurements to the end of the cycle [s]
};
void to_json(nlohmann::json& out, const CycleTimes& times);

class AnyParameter;
class CycleClock;

/// Observer of cycle ends, called on the cycle's thread; must not block.
class CycleListener {
public:
  virtual ~CycleListener() = default;
  virtual void onCycleEnd(TimePoint time, const std::vector<AnyProduction*>& productions) = 0;
};

/// A sequence of modules executed cyclically; keeps their order, pending parameter changes and cycle times.
class Thread {
public:
  /// `part` selects the configuration of its modules: the head's or the body's.
  Thread(std::string name, RobotPart part);

  /// Adds a module; must be called before wiring (Database).
  Module& add(std::unique_ptr<Module> module);
  template <class M, class... Arguments> M& add(Arguments&&... arguments) {
    return static_cast<M&>(add(std::make_unique<M>(std::forward<Arguments>(arguments)...)));
  }

  const std::string& name() const { return name_; }
  RobotPart part() const { return part_; }
  const std::vector<std::unique_ptr<Module>>& modules() const { return modules_; }
  std::vector<AnyProduction*> productions() const;

  /// Reorders the modules by index; called by Database.
  void sort(const std::vector<std::size_t>& order);

  static constexpr std::size_t changesPerCycle = 100; // bounds the work of a cycle; later cycles apply the others
  static constexpr std::size_t mostChanges = 1000;    // waiting; beyond, a new value replaces the parameter's last one

  /// Schedules a parameter change of a module for a later cycle, in the order of the calls; thread-safe.
  void postChange(Module& module, const AnyParameter& parameter, std::function<void()> apply);

  /// Registers the only listener; must be called before the first cycle.
  void setListener(CycleListener& listener) { listener_ = &listener; }

  /// Runs one cycle: applies parameter changes, runs every module in order, updates cycle times, notifies the listener.
  void cycle();

  /// Notifies every module after the last cycle.
  void end();

private:
  struct Change {
    Module* module;
    const AnyParameter* parameter;
    std::function<void()> apply;
  };
  void applyChanges();

  std::string name_;
  RobotPart part_;
  std::vector<std::unique_ptr<Module>> modules_;
  CycleClock* clock_ = nullptr;
  CycleListener* listener_ = nullptr;
  std::vector<AnyProduction*> productions_;

  // The cycle only tries to lock the mutex, and neither allocates nor frees what callers of `postChange` allocated: the
  // allocator's lock may be held by one of them that has lost its processor.
  std::mutex changesMutex_;
  std::list<Change> changes_, applied_; // to apply; to free in the next `postChange`
  std::list<Change> applying_;          // by the cycle
};

/// Requests SCHED_FIFO scheduling for the calling thread. Returns the reason of a failure, empty on success.
std::string requestRealTimePriority(int priority);

/// Requests a short time slice for the calling thread, with which it preempts ordinary threads as soon as it wakes: for
/// motion where the system refuses real-time priority. Needs no permission; Linux before 6.12 ignores it.
void requestShortSlice();

/// Makes the calling thread batch work: when it wakes, a running ordinary thread first finishes what it does (up to its
/// time slice). For vision, which motion and the cameras wake, where the system refuses real-time priority. Needs no
/// permission.
void letOthersFinish();

inline constexpr int backgroundNiceness = 10; // a tenth of the ordinary share of a processor

/// Makes the calling thread batch work below the ordinary threads and keeps it off one processor (the last one that it
/// may use), which remains free for motion where the system refuses real-time priority. Needs no permission.
void runInBackground();

} // namespace naocal
