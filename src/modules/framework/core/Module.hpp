#pragma once

#include "framework/core/Clock.hpp"
#include "framework/core/History.hpp"
#include "framework/core/Latest.hpp"

#include <atomic>
#include <concepts>
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <typeindex>
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
  virtual void onParametersChanged() {}

  /// Called when its thread has ended, while all modules are still there: what others do for it must end now.
  virtual void onThreadEnd() {}

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

/// What the wiring sees of a dependency.
class AnyDependency {
public:
  AnyDependency(Module& owner, std::string name, std::type_index type);
  AnyDependency(const AnyDependency&) = delete;
  AnyDependency& operator=(const AnyDependency&) = delete;

  const std::string& name() const { return name_; }
  std::type_index type() const { return type_; }

  /// Connects it with a production's value of its type.
  void connect(const void* value) { value_ = value; }

protected:
  const void* value_ = nullptr;

private:
  std::string name_;
  std::type_index type_;
};

/// A value that another module computes: `name` of the own thread, or `<thread>.<name>` of another one (History and
/// Latest only). Valid from the wiring on.
template <class T> class Dependency final : public AnyDependency {
public:
  Dependency(Module& owner, std::string name) : AnyDependency{owner, std::move(name), typeid(T)} {}

  const T& operator*() const { return *static_cast<const T*>(value_); }
  const T* operator->() const { return static_cast<const T*>(value_); }
};

/// A picture as the debug socket sends it.
struct EncodedImage {
  std::uint16_t width = 0, height = 0; // [px]
  std::string bytes;                   // a JPEG or PNG file
};

/// A type that is shown as a picture: `toImage` is declared beside it.
template <class T>
concept DisplayableAsImage = requires(const T& value) {
  { toImage(value) } -> std::same_as<EncodedImage>;
};

/// A copy of a production as it was in one cycle. The cycle only copies; whoever shows it turns it into text.
class Sample {
public:
  virtual ~Sample() = default;
  /// The value through its type's `to_json`; null for a picture.
  virtual void json(nlohmann::json& out) const = 0;
  /// Absent for what is no picture.
  virtual std::optional<EncodedImage> image() const = 0;
};

template <class T> class TypedSample final : public Sample {
public:
  explicit TypedSample(const T& value) : value_{value} {}
  void json(nlohmann::json& out) const override {
    if constexpr (!DisplayableAsImage<T>) {
      out = value_;
    }
  }
  std::optional<EncodedImage> image() const override {
    if constexpr (DisplayableAsImage<T>) {
      return toImage(value_);
    } else {
      return std::nullopt;
    }
  }

private:
  T value_;
};

/// How a production's value is copied for showing: nullptr where there is nothing to show.
template <class T> std::unique_ptr<const Sample> makeSample(const T& value) {
  return std::make_unique<TypedSample<T>>(value);
}
template <class T, std::size_t Capacity> std::unique_ptr<const Sample> makeSample(const History<T, Capacity>& history) {
  const auto entry = history.newest();
  return entry ? std::make_unique<TypedSample<T>>(entry->value) : nullptr;
}
template <class T> std::unique_ptr<const Sample> makeSample(const Latest<T>&) {
  return nullptr;
}

/// What is handed over belongs to its reader, and is not shown.
template <class T> inline constexpr bool isDisplayable = true;
template <class T> inline constexpr bool isDisplayable<Latest<T>> = false;

/// What the wiring and the debug socket see of a production. Its key is `<thread>.<name>`.
class AnyProduction {
public:
  AnyProduction(Module& owner, std::string name, std::type_index type, bool crossesThreads, int mostReaders);
  virtual ~AnyProduction() = default;
  AnyProduction(const AnyProduction&) = delete;
  AnyProduction& operator=(const AnyProduction&) = delete;

  const std::string& name() const { return name_; }
  std::type_index type() const { return type_; }
  bool crossesThreads() const { return crossesThreads_; }
  int mostReaders() const { return mostReaders_; } // 0: any number
  virtual bool isImage() const = 0;
  virtual bool isDisplayable() const = 0; // has a value that can be looked at
  virtual const void* value() const = 0;

  /// A copy for showing; nullptr where there is nothing to show.
  virtual std::unique_ptr<const Sample> sample() const = 0;

  /// Whether anybody wants to see it; set by the debug server's thread, read at the end of a cycle.
  void setWanted(bool wanted) { wanted_.store(wanted, std::memory_order_relaxed); }
  bool isWanted() const { return wanted_.load(std::memory_order_relaxed); }

  /// Whether it was edited in the current cycle.
  bool wasEdited() const { return edited_; }
  void beginCycle() { edited_ = false; }

protected:
  bool edited_ = false;

private:
  std::string name_;
  std::type_index type_;
  bool crossesThreads_;
  int mostReaders_;
  std::atomic<bool> wanted_{false};
};

template <class T> inline constexpr bool crossesThreads = false;
template <class T, std::size_t Capacity> inline constexpr bool crossesThreads<History<T, Capacity>> = true;
template <class T> inline constexpr bool crossesThreads<Latest<T>> = true;

template <class T> inline constexpr int mostReaders = 0;
template <class T> inline constexpr int mostReaders<Latest<T>> = 1;

/// A value that its module computes and others of its thread may depend on. Of another thread only History and Latest
/// can be depended on.
template <class T> class Production final : public AnyProduction {
public:
  Production(Module& owner, std::string name)
      : AnyProduction{owner, std::move(name), typeid(T), naocal::crossesThreads<T>, naocal::mostReaders<T>} {}

  const T& operator*() const { return value_; }
  const T* operator->() const { return &value_; }

  /// The value, to be changed in this cycle.
  T& edit() {
    edited_ = true;
    return value_;
  }
  Production& operator=(T value) {
    edit() = std::move(value);
    return *this;
  }

  bool isImage() const override { return DisplayableAsImage<T>; }
  bool isDisplayable() const override { return naocal::isDisplayable<T>; }
  const void* value() const override { return &value_; }
  std::unique_ptr<const Sample> sample() const override { return makeSample(value_); }

private:
  T value_{};
};

} // namespace naocal
