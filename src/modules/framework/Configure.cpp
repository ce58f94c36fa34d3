#include "framework/Configuration.hpp"
#include "framework/Database.hpp"
#include "framework/Errors.hpp"
#include "framework/Parameter.hpp"
#include "framework/Thread.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// `prepared` with the place in its refusal.
std::function<void()> preparedAt(AnyParameter& parameter, const nlohmann::json& value, const std::string& mount) {
  try {
    return parameter.prepared(value);
  } catch (const ConfigurationError& error) {
    throw ConfigurationError{fmt::format("{}: {}: {}", mount, parameter.key(), error.what())};
  }
}

void configure(Thread& thread, Module& module, Configuration& configuration, std::vector<std::string>& unknown) {
  const std::string mount = thread.name() + "." + module.name();
  const std::string file = module.name() + ".json";
  std::set<std::string> known, wishes;
  for (const AnyParameter* parameter : module.parameters()) {
    known.insert(parameter->key());
    if (parameter->isWish()) {
      wishes.insert(parameter->key());
    }
  }
  const auto listener = [&thread, &module, mount](const auto& key, const auto& value) {
    for (AnyParameter* parameter : module.parameters()) {
      if (parameter->key() == key) {
        thread.change(module, preparedAt(*parameter, value, mount));
      }
    }
  };
  configuration.mount(mount, file, thread.part(), listener, std::move(wishes));
  nlohmann::json keys;
  configuration.keys(mount, keys);
  for (AnyParameter* parameter : module.parameters()) {
    const auto entry = keys.find(parameter->key());
    if (entry == keys.end()) {
      throw ConfigurationError{fmt::format("{}: the parameter {} is missing; add it to {} in a location of the "
                                           "configuration",
                                           mount, parameter->key(), file)};
    }
    preparedAt(*parameter, *entry, mount)();
  }
  for (const auto& [key, value] : keys.items()) {
    if (!known.contains(key)) {
      unknown.push_back(fmt::format("{}: {} has a key \"{}\" that means nothing there; known are {}", mount, file, key,
                                    fmt::join(known, ", ")));
    }
  }
}

} // namespace

std::vector<std::string> configure(Thread& thread, Configuration& configuration) {
  std::vector<std::string> unknown;
  for (const auto& module : thread.modules()) {
    if (!module->parameters().empty()) {
      configure(thread, *module, configuration, unknown);
    }
    module->parametersChanged();
  }
  return unknown;
}

} // namespace naocal
