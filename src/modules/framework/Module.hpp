#pragma once

#include "framework/Clock.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

class AnyDependency;
class AnyParameter;
class AnyProduction;

/// One step of a thread's cycle. Its members are its contract with the others and with the configuration:
///
///     class Stillness : public Module {
///       Parameter<double> fastest_{*this, "fastestJoint"};        // [rad/s]
///       Dependency<JointSpeeds> speeds_{*this, "JointSpeeds"};
///       Production<bool> isStill_{*this, "isStill"};
///     };
///
/// Threads sort their modules so that each runs after those that it depends on.
class Module {
public:
  explicit Module(std::string name) : name_{std::move(name)} {}
  virtual ~Module() = default;
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;

  /// Computes the productions from dependencies and parameters, once per cycle of its thread.
  virtual void cycle() = 0;

  /// Called before the first cycle, and between cycles after each change of a parameter.
  virtual void parametersChanged() {}

  /// Called when its thread has ended, while all modules are still there: what others do for it must end now.
  virtual void ended() {}

  const std::string& name() const { return name_; }
  const std::vector<AnyParameter*>& parameters() const { return parameters_; }
  const std::vector<AnyDependency*>& dependencies() const { return dependencies_; }
  const std::vector<AnyProduction*>& productions() const { return productions_; }

  /// The time that this module gave to the current cycle; absent but for the one that waits for the hardware.
  std::optional<TimePoint> takeCycleTime() { return std::exchange(cycleTime_, std::nullopt); }

protected:
  /// Says when this cycle's measurements were taken. Called, once it has them, by the module that waits for them: time
  /// spent before that is waiting, not work.
  void setCycleTime(TimePoint time) { cycleTime_ = time; }

private:
  friend AnyDependency;
  friend AnyParameter;
  friend AnyProduction;

  std::string name_;
  std::vector<AnyParameter*> parameters_;
  std::vector<AnyDependency*> dependencies_;
  std::vector<AnyProduction*> productions_;
  std::optional<TimePoint> cycleTime_;
};

} // namespace naocal
