#include "framework/Configuration.hpp"
#include "framework/Database.hpp"
#include "framework/Errors.hpp"
#include "framework/Parameter.hpp"
#include "framework/Thread.hpp"

#include <algorithm>
#include <fmt/format.h>
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

void configure(Thread& thread, Module& module, Configuration& configuration) {
  const std::string mount = thread.name() + "." + module.name();
  const std::string file = module.name() + ".json";
  configuration.mount(mount, file, thread.part(), [&thread, &module, mount](const auto& key, const auto& value) {
    for (AnyParameter* parameter : module.parameters()) {
      if (parameter->key() == key) {
        thread.change(module, preparedAt(*parameter, value, mount));
      }
    }
  });
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
}

} // namespace

void configure(Thread& thread, Configuration& configuration) {
  for (const auto& module : thread.modules()) {
    if (!module->parameters().empty()) {
      configure(thread, *module, configuration);
    }
    module->parametersChanged();
  }
}

} // namespace naocal
