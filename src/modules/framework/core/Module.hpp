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

/// One step of a thread's cycle. Its members declare its interface to other modules and to the configuration:
///
///     class Stillness : public Module {
///       Parameter<double> fastest_{*this, "fastestJoint"};        // [rad/s]
///       Dependency<JointSpeeds> speeds_{*this, "JointSpeeds"};
///       Production<bool> isStill_{*this, "isStill"};
///     };
///
/// A thread sorts its modules so that each runs after the modules it depends on.
class Module {
public:
  explicit Module(std::string name) : name_{std::move(name)} {}
  virtual ~Module() = default;
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;

  /// Computes the productions from dependencies and parameters; called once per cycle of the thread.
  virtual void cycle() = 0;

  /// Called before the first cycle, and between cycles after each change of a parameter.
  virtual void onParametersChanged() {}

  /// Called when the thread has ended, before any module is destroyed: a module must stop using others here.
  virtual void onThreadEnd() {}

  const std::string& name() const { return name_; }
  const std::vector<AnyParameter*>& parameters() const { return parameters_; }
  const std::vector<AnyDependency*>& dependencies() const { return dependencies_; }
  const std::vector<AnyProduction*>& productions() const { return productions_; }

  /// The time stamp set for the current cycle; present only in the module that waits for the hardware.
  std::optional<TimePoint> takeCycleTime() { return std::exchange(cycleTime_, std::nullopt); }

protected:
  /// Sets the time of this cycle's measurements. The module that waits for measurements calls it once they have
  /// arrived; time spent before counts as waiting, not as work.
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

/// Type-erased dependency, as the wiring uses it.
class AnyDependency {
public:
  AnyDependency(Module& owner, std::string name, std::type_index type);
  AnyDependency(const AnyDependency&) = delete;
  AnyDependency& operator=(const AnyDependency&) = delete;

  const std::string& name() const { return name_; }
  std::type_index type() const { return type_; }

  /// Connects to a production's value; the caller guarantees that it has this type.
  void connect(const void* value) { value_ = value; }

protected:
  const void* value_ = nullptr;

private:
  std::string name_;
  std::type_index type_;
};

/// A value computed by another module: `name` in the same thread, or `<thread>.<name>` in another one (History and
/// Latest only). Valid after wiring.
template <class T> class Dependency final : public AnyDependency {
public:
  Dependency(Module& owner, std::string name) : AnyDependency{owner, std::move(name), typeid(T)} {}

  const T& operator*() const { return *static_cast<const T*>(value_); }
  const T* operator->() const { return static_cast<const T*>(value_); }
};

/// An image in the encoding of the debug protocol.
struct EncodedImage {
  std::uint16_t width = 0, height = 0; // [px]
  std::string bytes;                   // a JPEG or PNG file
};

/// A type displayed as an image; `toImage` is found by argument-dependent lookup.
template <class T>
concept DisplayableAsImage = requires(const T& value) {
  { toImage(value) } -> std::same_as<EncodedImage>;
};

/// A copy of a production's value in one cycle. The cycle thread only copies; another thread encodes.
class Sample {
public:
  virtual ~Sample() = default;
  /// The value through its type's `to_json`; null for an image.
  virtual void json(nlohmann::json& out) const = 0;
  /// The encoded image; absent if the type is not an image.
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

/// Copies a production's value for display; nullptr if there is nothing to display.
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

/// Whether values of the type can be displayed; false for Latest, whose value belongs to its reader.
template <class T> inline constexpr bool isDisplayable = true;
template <class T> inline constexpr bool isDisplayable<Latest<T>> = false;

/// Type-erased production, as the wiring and the debug socket use it. Its key is `<thread>.<name>`.
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
  virtual bool isDisplayable() const = 0; // can be shown by the debug socket
  virtual const void* value() const = 0;

  /// A copy for display; nullptr if there is nothing to display.
  virtual std::unique_ptr<const Sample> sample() const = 0;

  /// Whether a client subscribes to it; set by the debug server's thread, read at the end of a cycle.
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

/// A value that its module computes and other modules of the thread may read. Modules of other threads may read only
/// History and Latest.
template <class T> class Production final : public AnyProduction {
public:
  Production(Module& owner, std::string name)
      : AnyProduction{owner, std::move(name), typeid(T), naocal::crossesThreads<T>, naocal::mostReaders<T>} {}

  const T& operator*() const { return value_; }
  const T* operator->() const { return &value_; }

  /// Mutable access; marks the value as edited in this cycle.
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
