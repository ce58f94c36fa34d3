#pragma once

#include "framework/configuration/ConfigurationLayers.hpp"
#include "framework/core/Module.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace naocal {

/// How regularly and how long a thread works, over all its cycles.
struct CycleTimes {
  std::uint64_t cycles = 0;
  double period = 0, meanPeriod = 0, longestPeriod = 0; // from one cycle's measurements to the next ones [s]
  double work = 0, meanWork = 0, longestWork = 0;       // from the measurements' arrival to the end of the cycle [s]
};
void to_json(nlohmann::json& out, const CycleTimes& times);

class CycleClock;

/// Is told at the end of every cycle, on the cycle's thread: it must not wait for anything.
class CycleListener {
public:
  virtual ~CycleListener() = default;
  virtual void onCycleEnd(TimePoint time, const std::vector<AnyProduction*>& productions) = 0;
};

/// A cycle of modules, and what is common to them: their order, their parameters' changes, the cycle's times.
class Thread {
public:
  /// `part`: whose configuration its modules have, the head's or the body's.
  Thread(std::string name, RobotPart part);

  /// Adds a module; before the wiring (Database).
  Module& add(std::unique_ptr<Module> module);
  template <class M, class... Arguments> M& add(Arguments&&... arguments) {
    return static_cast<M&>(add(std::make_unique<M>(std::forward<Arguments>(arguments)...)));
  }

  const std::string& name() const { return name_; }
  RobotPart part() const { return part_; }
  const std::vector<std::unique_ptr<Module>>& modules() const { return modules_; }
  std::vector<AnyProduction*> productions() const;

  /// Puts the modules into the order of these indices (Database does).
  void sort(const std::vector<std::size_t>& order);

  /// Has a change of one module's parameters done before a later cycle; from any thread.
  void postChange(Module& module, std::function<void()> apply);

  /// Has one listener told of each cycle; before the first one.
  void setListener(CycleListener& listener) { listener_ = &listener; }

  /// Changes of parameters, every module in order, times, listener.
  void cycle();

  /// After the last cycle: tells every module.
  void end();

private:
  struct Change {
    Module* module;
    std::function<void()> apply;
  };
  void applyChanges();

  std::string name_;
  RobotPart part_;
  std::vector<std::unique_ptr<Module>> modules_;
  CycleClock* clock_ = nullptr;
  CycleListener* listener_ = nullptr;
  std::vector<AnyProduction*> productions_;

  std::mutex changesMutex_; // never waited for by the cycle
  std::vector<Change> changes_;
};

/// Asks the system to prefer the calling thread to all ordinary ones (SCHED_FIFO). Returns why not, empty on success.
std::string requestRealTimePriority(int priority);

} // namespace naocal
