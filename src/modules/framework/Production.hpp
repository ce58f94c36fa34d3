#pragma once

#include "framework/Module.hpp"
#include "framework/Sample.hpp"

#include <atomic>
#include <memory>
#include <string>
#include <typeindex>

namespace naocal {

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
  virtual bool isPicture() const = 0;
  virtual bool isShown() const = 0; // has a value that can be looked at
  virtual const void* value() const = 0;

  /// A copy for showing; nullptr where there is nothing to show.
  virtual std::unique_ptr<const Sample> sample() const = 0;

  /// Whether anybody wants to see it; set by the debug server's thread, read at the end of a cycle.
  void setWanted(bool wanted) { wanted_.store(wanted, std::memory_order_relaxed); }
  bool wanted() const { return wanted_.load(std::memory_order_relaxed); }

  /// Whether it was edited in the current cycle.
  bool edited() const { return edited_; }
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

  bool isPicture() const override { return ShownAsPicture<T>; }
  bool isShown() const override { return naocal::isShown<T>; }
  const void* value() const override { return &value_; }
  std::unique_ptr<const Sample> sample() const override { return sampleOf(value_); }

private:
  T value_{};
};

} // namespace naocal
