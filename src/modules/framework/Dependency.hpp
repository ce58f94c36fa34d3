#pragma once

#include "framework/Module.hpp"

#include <string>
#include <typeindex>

namespace naocal {

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

} // namespace naocal
